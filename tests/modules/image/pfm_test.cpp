#include "image/image_file.h"

#include "random_image.h"
#include "support/error_of.h"
#include "support/scratch_folder.h"

#include "catch.h"

#include <rapidcheck.h>

#include <bit>
#include <cstdint>

using namespace raysteps;

namespace {

// 1.0f is 3f800000, 3.14159274f is 40490fdb (four different bytes), -2.0f is c0000000.
const std::string two_pixels("PF\n2 1\n-1.0\n"
                             "\0\0\x80\x3f\0\0\0\0\xdb\x0f\x49\x40"
                             "\0\0\0\xc0\0\0\x80\x3f\0\0\x80\x3f",
                             36);

std::string error_of_reading(const ScratchFolder& folder, const std::string& bytes) {
    put_bytes(folder / "file.pfm", bytes);
    return error_of([&] { read_pfm(folder / "file.pfm"); });
}

std::vector<std::uint32_t> bits_of(const Image& image) {
    std::vector<std::uint32_t> bits;
    for (const glm::vec3& pixel : image.pixels) {
        bits.push_back(std::bit_cast<std::uint32_t>(pixel.x));
        bits.push_back(std::bit_cast<std::uint32_t>(pixel.y));
        bits.push_back(std::bit_cast<std::uint32_t>(pixel.z));
    }
    return bits;
}

} // namespace

TEST_CASE("a PFM file of two pixels has exactly the known bytes", "[image]") {
    const ScratchFolder folder("pfm_known");
    Image image(2, 1);
    image.at(0, 0) = {1.0f, 0.0f, 3.14159274f};
    image.at(1, 0) = {-2.0f, 1.0f, 1.0f};
    write_pfm(folder / "two.pfm", image);
    CHECK(bytes_of(folder / "two.pfm") == two_pixels);
}

TEST_CASE("a PFM file begins with the bottom row", "[image]") {
    const ScratchFolder folder("pfm_rows");
    Image image(1, 2);
    image.at(0, 0) = glm::vec3(1.0f);
    image.at(0, 1) = glm::vec3(0.0f);
    write_pfm(folder / "rows.pfm", image);
    const std::string bytes = bytes_of(folder / "rows.pfm");
    REQUIRE(bytes.size() == 36);
    CHECK(bytes.substr(12, 12) == std::string(12, '\0'));
    CHECK(read_pfm(folder / "rows.pfm").at(0, 0) == glm::vec3(1.0f));
}

TEST_CASE("a PFM file of big endian is read too", "[image]") {
    const ScratchFolder folder("pfm_big");
    put_bytes(folder / "big.pfm",
              std::string("PF\n1 1\n1.0\n\x3f\x80\0\0\x3f\0\0\0\xc0\0\0\0", 23));
    CHECK(read_pfm(folder / "big.pfm").at(0, 0) == glm::vec3(1.0f, 0.5f, -2.0f));
}

TEST_CASE("every bit comes back from a PFM file even those of NaN", "[image]") {
    const ScratchFolder folder("pfm_round_trip");
    REQUIRE(rc::check([&folder] {
        const rc::Gen<float> any_bits =
            rc::gen::map(rc::gen::arbitrary<std::uint32_t>(),
                         [](std::uint32_t bits) { return std::bit_cast<float>(bits); });
        const Image image = random_image(any_bits);
        write_pfm(folder / "image.pfm", image);
        const Image read = read_pfm(folder / "image.pfm");
        RC_ASSERT(read.width == image.width);
        RC_ASSERT(read.height == image.height);
        RC_ASSERT(bits_of(read) == bits_of(image));
    }));
}

TEST_CASE("a PFM file that ends early or goes on too long is an error", "[image]") {
    const ScratchFolder folder("pfm_length");
    for (std::size_t length = 0; length < two_pixels.size(); length++) {
        CAPTURE(length);
        CHECK(error_of_reading(folder, two_pixels.substr(0, length)).find("file.pfm") !=
              std::string::npos);
    }
    CHECK(error_of_reading(folder, two_pixels + "x").find("has 36 bytes, but this one has 37") !=
          std::string::npos);
}

TEST_CASE("a PFM header that is not one is an error with its line", "[image]") {
    const ScratchFolder folder("pfm_header");
    const std::string pixel(12, '\0');
    const auto error = [&](const std::string& header) {
        return error_of_reading(folder, header + pixel);
    };
    REQUIRE(error("PF\n1 1\n-1.0\n").empty());
    CHECK(error("Pf\n1 1\n-1.0\n").find("pfm:1:") != std::string::npos);
    CHECK(error("P6\n1 1\n-1.0\n").find("pfm:1:") != std::string::npos);
    CHECK(error("PF\n1\n-1.0\n").find("pfm:2:") != std::string::npos);
    CHECK(error("PF\n1 x\n-1.0\n").find("pfm:2:") != std::string::npos);
    CHECK(error("PF\n1.5 1\n-1.0\n").find("pfm:2:") != std::string::npos);
    CHECK(error("PF\n1 1 1\n-1.0\n").find("pfm:2:") != std::string::npos);
    CHECK(error("PF\n1 1\n0\n").find("pfm:3:") != std::string::npos);
    CHECK(error("PF\n1 1\n-2.0\n").find("pfm:3:") != std::string::npos);
    CHECK(error("PF\n1 1\nnan\n").find("pfm:3:") != std::string::npos);
    CHECK(error("PF\n1 1\n-1.0" + std::string(100, '0') + "\n").find("pfm:3:") !=
          std::string::npos);
}

TEST_CASE("a PFM file of absurd size is an error that costs no memory", "[image]") {
    const ScratchFolder folder("pfm_absurd");
    for (const std::string size : {"0 1", "1 0", "-1 -1", "16385 1", "16384 16384",
                                   "2147483647 2147483647", "99999999999999999999 1"}) {
        CAPTURE(size);
        CHECK(error_of_reading(folder, "PF\n" + size + "\n-1.0\n").find("pfm:2:") !=
              std::string::npos);
    }
    CHECK(error_of_reading(folder, "PF\n8192 8192\n-1.0\n").find("this one has 18") !=
          std::string::npos);
}

TEST_CASE("a PFM path that is a folder or lacks is an error", "[image]") {
    const ScratchFolder folder("pfm_paths");
    CHECK(error_of([&] { read_pfm(folder / ""); }).find("folder") != std::string::npos);
    CHECK(error_of([&] { read_pfm(folder / "no.pfm"); }).find("no such file") != std::string::npos);
}
