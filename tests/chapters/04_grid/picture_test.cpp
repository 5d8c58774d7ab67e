#include "catch.h"
#include "support/expected_picture.h"
#include "support/pictures_by.h"

using namespace raysteps;

TEST_CASE("the normals of the bunny are the expected ones by every walk of chapter 04",
          "[04][picture]") {
    const auto context = make_context(ContextKind::automatic);
    for (const auto& [walk, picture] : pictures_by({"grid", "grid_mailbox"})) {
        CAPTURE(walk);
        CHECK(pixels_unlike(picture, "tests/support/bunny_normals.png") == 0);
    }
}

TEST_CASE("the opening picture of chapter 04 is the expected one", "[04][picture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(unexpected_pixels(visits_by("grid"), "04_grid") == 0);
}
