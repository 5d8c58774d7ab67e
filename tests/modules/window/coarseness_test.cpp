#include "program/window/screen.h"

#include "catch.h"

#include <rapidcheck.h>

#include <cmath>

using namespace raysteps;

TEST_CASE("a frame is as fine as a tenth of a second affords", "[window]") {
    CHECK(affordable_coarseness(1, 0.05) == 1);
    CHECK(affordable_coarseness(1, 0.3) == 2);   // 0.3 / 4 seconds
    CHECK(affordable_coarseness(1, 0.5) == 4);   // 0.5 / 16; at 2 it would take 0.125
    CHECK(affordable_coarseness(8, 0.001) == 1); // 0.064
    CHECK(affordable_coarseness(8, 0.01) == 4);  // 0.04; at 2 it would take 0.16
    CHECK(affordable_coarseness(8, 0.2) == 16);
    CHECK(affordable_coarseness(16, 1e9) == 16);
    CHECK(affordable_coarseness(1, 0.0) == 1);
}

TEST_CASE("the coarseness is the least power of two that is affordable", "[window]") {
    REQUIRE(rc::check("affordable", [] {
        const int before = 1 << *rc::gen::inRange(0, 5);
        const double seconds = std::ldexp(1.0, *rc::gen::inRange(-20, 10));
        const int after = affordable_coarseness(before, seconds);
        const auto seconds_at = [&](int coarseness) {
            const double ratio = static_cast<double>(before) / coarseness;
            return seconds * ratio * ratio;
        };
        RC_ASSERT(after == 16 || seconds_at(after) <= 0.1);
        RC_ASSERT(after == 1 || seconds_at(after / 2) > 0.1);
    }));
}

TEST_CASE("what is not shown yet comes as fine as affordable", "[window]") {
    CHECK(next_coarseness(0, 8) == 8);
    CHECK(next_coarseness(0, 1) == 1);
}

TEST_CASE("a picture at rest gets finer frame by frame until it is full", "[window]") {
    CHECK(next_coarseness(16, 16) == 8);
    CHECK(next_coarseness(8, 1) == 1);
    for (const int affordable : {1, 2, 4, 8, 16}) {
        int shown = 0;
        int frames = 0;
        while (shown != 1) {
            shown = next_coarseness(shown, affordable);
            ++frames;
            REQUIRE(frames <= 5);
        }
    }
}

TEST_CASE("a wanted frame comes at once and a finer one when the camera rests", "[window]") {
    CHECK(wait_before_frame(0, 0.0) == 0.0);
    CHECK(wait_before_frame(8, 0.05) == Approx(0.1));
    CHECK(wait_before_frame(8, 0.2) == 0.0);
    CHECK(std::isinf(wait_before_frame(1, 100.0)));
}

TEST_CASE("a coarse picture has at least one pixel", "[window]") {
    CHECK(coarse_side(1, 16) == 1);
    CHECK(coarse_side(640, 1) == 640);
    CHECK(coarse_side(641, 4) == 160);
    CHECK(coarse_side(643, 4) == 161);
}
