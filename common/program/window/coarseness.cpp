#include "program/window/coarseness.h"

#include <algorithm>
#include <limits>

namespace raysteps {

namespace {

constexpr int coarsest = 16;
constexpr double fluent_frame = 0.1; // seconds; Card, Moran and Newell (1983): seems immediate
constexpr double rest = 0.15;        // seconds without a move after which a drag seems to be over

} // namespace

int affordable_coarseness(int coarseness, double seconds) {
    int affordable = coarsest;
    while (affordable > 1) {
        const double ratio = 2.0 * coarseness / affordable;
        if (seconds * ratio * ratio > fluent_frame) {
            break;
        }
        affordable /= 2;
    }
    return affordable;
}

int next_coarseness(int shown, int affordable) {
    if (shown == 0) {
        return affordable;
    }
    return std::max(1, std::min(shown / 2, affordable));
}

double wait_before_frame(int shown, double seconds_at_rest) {
    if (shown == 0) {
        return 0.0;
    }
    if (shown == 1) {
        return std::numeric_limits<double>::infinity();
    }
    return std::max(0.0, rest - seconds_at_rest);
}

int coarse_side(int side, int coarseness) {
    return std::max(1, (side + coarseness / 2) / coarseness);
}

} // namespace raysteps
