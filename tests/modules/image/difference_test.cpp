#include "image/difference.h"

#include "random_image.h"
#include "support/error_of.h"

#include "catch.h"

#include <rapidcheck.h>

#include <cmath>
#include <limits>

using namespace raysteps;

TEST_CASE("one known pixel makes the known difference", "[image]") {
    const Image a(2, 2);
    Image b(2, 2);
    b.at(1, 0) = {0.0f, -0.75f, 0.5f};
    b.at(0, 1) = {0.25f, 0.0f, 0.0f};
    const Difference result = difference(a, b, 0.25f);
    CHECK(result.max == 0.75);
    CHECK(result.worst_column == 1);
    CHECK(result.worst_row == 0);
    CHECK(result.different_pixels == 1); // 0.25 is not more than the threshold
    CHECK(result.nan_pixels == 0);
    CHECK(result.pixels == 4);
    CHECK(result.rmse == std::sqrt((0.5625 + 0.25 + 0.0625) / 12.0));
}

TEST_CASE("NaN is infinitely far from everything", "[image]") {
    Image a(2, 1);
    Image b(2, 1);
    a.at(1, 0).y = not_a_number;
    for (const float other : {0.0f, infinity, not_a_number}) {
        CAPTURE(other);
        b.at(1, 0).y = other;
        const Difference result = difference(a, b, 1000.0f);
        CHECK(std::isinf(result.rmse));
        CHECK(std::isinf(result.max));
        CHECK(result.worst_column == 1);
        CHECK(result.different_pixels == 1);
        CHECK(result.nan_pixels == 1);
    }
}

TEST_CASE("equal infinities do not differ and others do", "[image]") {
    Image a(1, 1);
    a.at(0, 0) = glm::vec3(infinity);
    CHECK(difference(a, a, 0.0f).max == 0.0);
    CHECK(std::isinf(difference(a, Image(1, 1), 0.0f).rmse));
}

TEST_CASE("a picture does not differ from itself", "[image]") {
    REQUIRE(rc::check([] {
        const Image image = random_image(rc::gen::arbitrary<float>());
        const Difference result = difference(image, image, 0.0f);
        RC_ASSERT(result.rmse == 0.0);
        RC_ASSERT(result.max == 0.0);
        RC_ASSERT(result.different_pixels == 0U);
    }));
}

TEST_CASE("the difference is the same both ways and rmse is at most the maximum", "[image]") {
    REQUIRE(rc::check([] {
        const Image a = random_image(rc::gen::arbitrary<float>());
        Image b = a;
        for (glm::vec3& pixel : b.pixels) {
            pixel.x = *rc::gen::arbitrary<float>();
        }
        const Difference forth = difference(a, b, 0.5f);
        const Difference back = difference(b, a, 0.5f);
        RC_ASSERT(forth.rmse == back.rmse);
        RC_ASSERT(forth.max == back.max);
        RC_ASSERT(forth.different_pixels == back.different_pixels);
        RC_ASSERT(forth.rmse <= forth.max);
    }));
}

TEST_CASE("pictures of two sizes and a threshold that separates nothing are errors", "[image]") {
    const Image a(2, 3);
    CHECK(error_of([&] { difference(a, Image(3, 2), 0.0f); }).find("2 x 3") != std::string::npos);
    CHECK(error_of([&] { difference(Image(), Image(), 0.0f); }).find("no pixel") !=
          std::string::npos);
    Image too_few = a;
    too_few.pixels.pop_back();
    CHECK(error_of([&] { difference(too_few, a, 0.0f); }).find("first") != std::string::npos);
    CHECK(error_of([&] { difference(a, too_few, 0.0f); }).find("second") != std::string::npos);
    for (const float threshold : {-1.0f, infinity, not_a_number}) {
        CHECK(error_of([&] { difference(a, a, threshold); }).find("threshold") !=
              std::string::npos);
    }
}
