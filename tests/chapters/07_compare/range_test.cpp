#include "basics/statistics.h"
#include "catch.h"

using namespace raysteps;

TEST_CASE("the median of rounds is a value that was measured", "[07][range]") {
    const MeasuredRange odd = measured_range({5.0, 1.0, 4.0, 2.0, 1000.0});
    CHECK(odd.median == 4.0);
    CHECK(odd.lowest == 1.0);
    CHECK(odd.highest == 1000.0);
    CHECK(measured_range({5.0, 1.0, 4.0, 2.0}).median == 4.0);
    CHECK(measured_range({7.0}).median == 7.0);
}

TEST_CASE("a range lies below another one only where no two rounds say otherwise", "[07][range]") {
    const MeasuredRange low{2.0, 1.0, 3.0};
    CHECK(lies_below(low, {5.0, 4.0, 6.0}));
    CHECK_FALSE(lies_below({5.0, 4.0, 6.0}, low));
    CHECK_FALSE(lies_below(low, {4.0, 3.0, 5.0})); // they touch
    CHECK_FALSE(lies_below(low, {4.0, 2.5, 5.0}));
    CHECK_FALSE(lies_below(low, low));
}
