#include "image/image_file.h"

#include "support/error_of.h"
#include "support/scratch_folder.h"

#include "image/color.h"

#include "catch.h"

#include <glm/common.hpp>

using namespace raysteps;

namespace {

// 16 x 8 pixels: the left half (200, 40, 40), the right half (30, 60, 180); ImageMagick made them.
const std::filesystem::path files =
    std::filesystem::path(RAYSTEPS_SOURCE_DIR) / "tests/modules/image/files";
const glm::vec3 left(200, 40, 40);
const glm::vec3 right(30, 60, 180);

float greatest_step(const glm::vec3& pixel, const glm::vec3& steps) {
    const glm::vec3 read(srgb_from_linear(pixel.x), srgb_from_linear(pixel.y),
                         srgb_from_linear(pixel.z));
    const glm::vec3 off = glm::abs(255.0f * read - steps);
    return glm::max(off.x, glm::max(off.y, off.z));
}

} // namespace

TEST_CASE("a BMP file gives its colors", "[image][picture]") {
    const Image image = read_picture(files / "two_halves.bmp");
    REQUIRE(image.width == 16);
    REQUIRE(image.height == 8);
    // A step of 1 in 255 comes back as itself, but for the rounding of the curve.
    CHECK(greatest_step(image.at(0, 0), left) < 0.01f);
    CHECK(greatest_step(image.at(15, 7), right) < 0.01f);
}

TEST_CASE("a JPEG file gives its colors as exactly as it holds them", "[image][picture]") {
    const Image image = read_picture(files / "two_halves.jpg");
    REQUIRE(image.width == 16);
    REQUIRE(image.height == 8);
    // Each block of 8 x 8 is one color, so only its mean is stored: luma in steps of 2/8, chroma in
    // steps of 2/8 or 3/8 at this quality; then all are rounded to whole numbers, twice. A chroma
    // that is off by 1 moves blue by 1.77, and luma adds 1.
    CHECK(greatest_step(image.at(3, 3), left) <= 3.0f);
    CHECK(greatest_step(image.at(12, 4), right) <= 3.0f);
}

TEST_CASE("the content says what a picture is and not its name", "[image][picture]") {
    const ScratchFolder folder("misnamed_picture");
    std::filesystem::copy_file(files / "two_halves.jpg", folder / "texture.png");
    CHECK(read_picture(folder / "texture.png").width == 16);
}

TEST_CASE("what is not a picture is refused with the kinds that can be read", "[image][picture]") {
    const ScratchFolder folder("no_texture");
    put_bytes(folder / "texture.gif", "GIF89a, it says");
    const std::string error = error_of([&] { read_picture(folder / "texture.gif"); });
    CHECK(error.find("texture.gif: is not a PNG, JPEG, TGA or BMP picture that can be read") !=
          std::string::npos);
}
