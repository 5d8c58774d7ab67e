#include "catch.h"
#include "support/expected_picture.h"
#include "support/picture_by.h"

using namespace raysteps;

TEST_CASE("the picture of chapter 04 is the expected one", "[04][picture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(unexpected_pixels(picture_by("grid"), "04_grid") == 0);
}

TEST_CASE("the mailbox paints the picture of chapter 04", "[04][picture]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK(unexpected_pixels(picture_by("grid_mailbox"), "04_grid") == 0);
}
