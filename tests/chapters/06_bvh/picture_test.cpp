#include "catch.h"
#include "support/expected_picture.h"
#include "support/pictures_by.h"

using namespace raysteps;

TEST_CASE("the picture of chapter 06 is the expected one by every walk", "[06][picture]") {
    const auto context = make_context(ContextKind::automatic);
    for (const auto& [walk, picture] :
         pictures_by({"bvh_skip", "bvh_skip_padded", "bvh_ordered", "bvh_parent", "bvh_stack"})) {
        CAPTURE(walk);
        CHECK(unexpected_pixels(picture, "06_bvh") == 0);
    }
}
