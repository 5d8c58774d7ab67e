#include "catch.h"
#include "effect_pictures.h"
#include "support/expected_picture.h"

using namespace raysteps;

TEST_CASE("the picture of chapter 09 is the expected one", "[09][picture]") {
    const auto context = make_context(ContextKind::automatic);
    const EffectPicture picture = effect_picture(load_scene("glass_box", 1.0f), 128);
    // Where glass bends a ray, a driver's last bit may move what is seen over an edge: a few of
    // 16,384 pixels.
    CHECK(unexpected_pixels(picture.image, "09_effects") <= 16);
}
