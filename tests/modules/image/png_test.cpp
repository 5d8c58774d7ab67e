#include "image/image_file.h"

#include "random_image.h"
#include "support/error_of.h"
#include "support/scratch_folder.h"

#include "image/color.h"
#include "image/image.h"

#include "catch.h"

#include <rapidcheck.h>

#include <limits>

using namespace raysteps;

namespace {

// A red pixel and one of the gray step 188, as zlib and the PNG specification make them.
const std::string two_pixel_png(
    "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x02\0\0\0\x01\x08\x02\0\0\0\x7b\x40\xe8\xdd"
    "\0\0\0\x0fIDAT\x78\xda\x63\xf8\xcf\xc0\xb0\x67\xcf\x1e\0\x0a\x69\x03\x34\x89\xc3\x77\x01"
    "\0\0\0\0IEND\xae\x42\x60\x82",
    72);
constexpr std::size_t width_byte = 16; // of the four in a PNG header, the most significant first

} // namespace

TEST_CASE("a known PNG file has the colors that were stored", "[image]") {
    const ScratchFolder folder("known_png");
    put_bytes(folder / "two.png", two_pixel_png);
    const Image image = read_picture(folder / "two.png");
    REQUIRE(image.width == 2);
    REQUIRE(image.height == 1);
    CHECK(image.at(0, 0) == glm::vec3(1.0f, 0.0f, 0.0f));
    CHECK(image.at(1, 0) == glm::vec3(decode_srgb(188)));
}

TEST_CASE("a written PNG file is sRGB encoded with row 0 on top", "[image]") {
    const ScratchFolder folder("png_rows");
    Image image(1, 2);
    image.at(0, 0) = glm::vec3(0.5f);
    image.at(0, 1) = {2.0f, -1.0f, 1.0f};
    write_png(folder / "rows.png", image);
    CHECK(bytes_of(folder / "rows.png").substr(0, 8) == two_pixel_png.substr(0, 8));
    const Image read = read_picture(folder / "rows.png");
    CHECK(read.at(0, 0) == glm::vec3(decode_srgb(188)));
    CHECK(read.at(0, 1) == glm::vec3(1.0f, 0.0f, 1.0f));
}

TEST_CASE("a pixel that has NaN is magenta in a PNG file and is counted", "[image]") {
    const ScratchFolder folder("png_nan");
    Image image(2, 1);
    image.at(1, 0) = {0.5f, std::numeric_limits<float>::quiet_NaN(), 0.5f};
    write_png(folder / "nan.png", image);
    const Image read = read_picture(folder / "nan.png");
    CHECK(read.at(0, 0) == glm::vec3(0.0f));
    CHECK(read.at(1, 0) == nan_color);
    CHECK(count_nan_pixels(image) == 1);
}

TEST_CASE("colors of 8 bits come back from a PNG file", "[image]") {
    const ScratchFolder folder("png_round_trip");
    REQUIRE(rc::check([&folder] {
        const rc::Gen<float> step =
            rc::gen::map(rc::gen::arbitrary<std::uint8_t>(),
                         [](std::uint8_t value) { return decode_srgb(value); });
        const Image image = random_image(step);
        write_png(folder / "image.png", image);
        const Image read = read_picture(folder / "image.png");
        RC_ASSERT(read.width == image.width);
        RC_ASSERT(read.height == image.height);
        RC_ASSERT(read.pixels == image.pixels);
    }));
}

TEST_CASE("a PNG file that ends too early is an error", "[image]") {
    const ScratchFolder folder("png_truncated");
    const std::size_t without_end_chunk = two_pixel_png.size() - 12;
    for (std::size_t length = 0; length < without_end_chunk; length++) {
        CAPTURE(length);
        put_bytes(folder / "short.png", two_pixel_png.substr(0, length));
        CHECK(error_of([&] { read_picture(folder / "short.png"); }).find("short.png") !=
              std::string::npos);
    }
}

TEST_CASE("a damaged PNG file is read or is an error and never worse", "[image]") {
    const ScratchFolder folder("png_damaged");
    REQUIRE(rc::check([&folder] {
        std::string bytes = two_pixel_png;
        bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
        put_bytes(folder / "damaged.png", bytes);
        error_of([&] { read_picture(folder / "damaged.png"); });
    }));
}

TEST_CASE("a PNG file of absurd size is an error that names the size", "[image]") {
    const ScratchFolder folder("png_absurd");
    std::string bytes = two_pixel_png;
    bytes[width_byte + 1] = '\x01'; // 65,538 columns
    put_bytes(folder / "absurd.png", bytes);
    CHECK(error_of([&] { read_picture(folder / "absurd.png"); }).find("65538 x 1") !=
          std::string::npos);
    bytes[width_byte] = '\x7f';
    put_bytes(folder / "absurd.png", bytes);
    CHECK(!error_of([&] { read_picture(folder / "absurd.png"); }).empty());
}

TEST_CASE("a small PNG picture in a large file is refused before it is unpacked", "[image]") {
    const ScratchFolder folder("png_bomb");
    put_bytes(folder / "bomb.png", two_pixel_png + std::string(1 << 20, '\0'));
    CHECK(error_of([&] { read_picture(folder / "bomb.png"); }).find("too many for its 2 pixels") !=
          std::string::npos);
}

TEST_CASE("a PNG path that is a folder or lacks is an error", "[image]") {
    const ScratchFolder folder("png_paths");
    CHECK(error_of([&] { read_picture(folder / ""); }).find("folder") != std::string::npos);
    CHECK(error_of([&] { read_picture(folder / "no.png"); }).find("no such file") !=
          std::string::npos);
}

TEST_CASE("a picture without pixels or with too few is not written", "[image]") {
    const ScratchFolder folder("png_empty");
    CHECK(error_of([&] { write_png(folder / "no.png", Image()); }).find("no pixel") !=
          std::string::npos);
    Image image(2, 2);
    image.pixels.pop_back();
    CHECK(error_of([&] { write_png(folder / "no.png", image); }).find("holds 3 pixels") !=
          std::string::npos);
    CHECK(folder.file_count() == 0);
}
