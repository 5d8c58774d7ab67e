#include "image/image.h"

#include "count_ink.h"
#include "support/error_of.h"

#include "catch.h"

#include <vector>

using namespace raysteps;

namespace {

const glm::vec3 red{1.0f, 0.0f, 0.0f};
const glm::vec3 blue{0.0f, 0.0f, 1.0f};

std::vector<Image> two_images() {
    return {blank(200, 50, red), blank(150, 50, blue)};
}

} // namespace

TEST_CASE("pictures stand side by side over their captions with a gap between", "[image]") {
    const std::vector<std::string> captions{"left", "right"};
    const Image image = side_by_side(two_images(), captions);
    REQUIRE(image.width == 200 + 4 + 150);
    REQUIRE(image.height > 50);
    CHECK(image.at(0, 0) == red);
    CHECK(image.at(199, 49) == red);
    CHECK(count_paper(image, {200, 204, 0, image.height}) == 4 * image.height);
    CHECK(image.at(204, 0) == blue);
    CHECK(image.at(353, 49) == blue);
    CHECK(count_ink(image, {0, 200, 50, image.height}) > 0);
    CHECK(count_ink(image, {204, 354, 50, image.height}) > 0);
}

TEST_CASE("a caption may be empty or long", "[image]") {
    const std::vector<std::string> captions{"", "a caption of more than one line in all"};
    const Image image = side_by_side(two_images(), captions);
    CHECK(image.width == 354);
    CHECK(count_ink(image, {0, 200, 50, image.height}) == 0);
    CHECK(count_ink(image, {204, 354, 50 + 8 + text_line_height, image.height}) > 0);
}

TEST_CASE("pictures that cannot be joined are an error", "[image]") {
    const auto error = [](const std::vector<Image>& images,
                          const std::vector<std::string>& captions) {
        return error_of([&] { side_by_side(images, captions); });
    };
    CHECK(error({}, {}).find("at least one picture") != std::string::npos);
    CHECK(error(two_images(), {"one"}).find("2 pictures with 1 captions") != std::string::npos);
    CHECK(error({Image(2, 2), Image(2, 3)}, {"a", "b"}).find("2 and 3 rows") != std::string::npos);
    CHECK(error({Image()}, {"a"}).find("picture 1") != std::string::npos);
    const std::vector<Image> many(5, Image(4000, 1));
    CHECK(error(many, std::vector<std::string>(5)).find("over the limit") != std::string::npos);
}

TEST_CASE("what is pasted beyond the canvas is cut off", "[image]") {
    const Image canvas = paste(blank(3, 2, paper_color), blank(9, 9, red), 2, 1);
    CHECK(count_paper(canvas, {0, 3, 0, 2}) == 5);
    CHECK(canvas.at(2, 1) == red);
    const Image corner = paste(blank(3, 2, paper_color), blank(9, 9, red), -8, -8);
    CHECK(count_paper(corner, {0, 3, 0, 2}) == 5);
    CHECK(corner.at(0, 0) == red);
    const Image untouched = paste(blank(3, 2, paper_color), blank(9, 9, red), 50, -50);
    CHECK(count_paper(untouched, {0, 3, 0, 2}) == 6);
}
