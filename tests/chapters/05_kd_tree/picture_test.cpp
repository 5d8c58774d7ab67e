#include "catch.h"
#include "support/expected_picture.h"
#include "support/pictures_by.h"

using namespace raysteps;

TEST_CASE("the picture of chapter 05 is the expected one by every walk", "[05][picture]") {
    const auto context = make_context(ContextKind::automatic);
    for (const auto& [walk, picture] :
         pictures_by({"kd_restart", "kd_backtrack", "kd_short_stack", "kd_ropes"})) {
        CAPTURE(walk);
        CHECK(unexpected_pixels(picture, "05_kd_tree") == 0);
    }
}
