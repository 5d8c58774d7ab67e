#include "catch.h"
#include "support/expected_picture.h"
#include "support/pictures_by.h"

using namespace raysteps;

TEST_CASE("the picture of chapter 04 is the expected one by every walk", "[04][picture]") {
    const auto context = make_context(ContextKind::automatic);
    for (const auto& [walk, picture] : pictures_by({"grid", "grid_mailbox"})) {
        CAPTURE(walk);
        CHECK(unexpected_pixels(picture, "04_grid") == 0);
    }
}
