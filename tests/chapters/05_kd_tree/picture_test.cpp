#include "catch.h"
#include "support/expected_picture.h"
#include "support/pictures_by.h"

using namespace raysteps;

TEST_CASE("the normals of the bunny are the expected ones by every walk of chapter 05",
          "[05][picture]") {
    const auto context = make_context(ContextKind::automatic);
    for (const auto& [walk, picture] :
         pictures_by({"kd_restart", "kd_backtrack", "kd_short_stack", "kd_ropes"})) {
        CAPTURE(walk);
        CHECK(pixels_unlike(picture, "tests/support/bunny_normals.png") == 0);
    }
}

TEST_CASE("the opening picture of chapter 05 is the expected one", "[05][picture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(unexpected_pixels(visits_by("kd_restart"), "05_kd_tree") == 0);
}
