#include "catch.h"
#include "support/expected_picture.h"
#include "support/pictures_by.h"

using namespace raysteps;

TEST_CASE("the normals of the bunny are the expected ones by every walk of chapter 06",
          "[06][picture]") {
    const auto context = make_context(ContextKind::automatic);
    std::map<std::string, Image> pictures =
        pictures_by({"bvh_skip", "bvh_skip_padded", "bvh_ordered", "bvh_parent", "bvh_stack"});
    pictures.merge(pictures_by({"bvh4"})); // through a structure of its own
    for (const auto& [walk, picture] : pictures) {
        CAPTURE(walk);
        CHECK(pixels_unlike(picture, "tests/support/bunny_normals.png") == 0);
    }
}

TEST_CASE("the opening picture of chapter 06 is the expected one", "[06][picture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(unexpected_pixels(visits_by("bvh_ordered"), "06_bvh") == 0);
}
