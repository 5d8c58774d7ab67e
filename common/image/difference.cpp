#include "image/difference.h"

#include "basics/error.h"
#include "image/image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace raysteps {

namespace {

double component_difference(float a, float b) {
    if (a == b) {
        return 0.0; // equal infinities too, whose subtraction is NaN
    }
    const double distance = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

void check_comparable(const Image& a, const Image& b, float threshold) {
    check_image("first picture", a);
    check_image("second picture", b);
    if (a.width != b.width || a.height != b.height) {
        throw InputError("cannot compare a picture of " + std::to_string(a.width) + " x " +
                         std::to_string(a.height) + " pixels with one of " +
                         std::to_string(b.width) + " x " + std::to_string(b.height) +
                         ". Render both at the same size.");
    }
    if (!std::isfinite(threshold) || threshold < 0.0f) {
        throw InputError("a threshold of " + std::to_string(threshold) +
                         " cannot separate pixels. Give a finite one of 0 or more.");
    }
}

} // namespace

Difference difference(const Image& a, const Image& b, float threshold) {
    check_comparable(a, b, threshold);
    Difference result;
    result.pixels = a.pixels.size();
    double sum_of_squares = 0.0;
    for (int row = 0; row < a.height; row++) {
        for (int column = 0; column < a.width; column++) {
            const glm::vec3& left = a.at(column, row);
            const glm::vec3& right = b.at(column, row);
            const double red = component_difference(left.x, right.x);
            const double green = component_difference(left.y, right.y);
            const double blue = component_difference(left.z, right.z);
            sum_of_squares += red * red + green * green + blue * blue;

            const double most = std::max({red, green, blue});
            result.different_pixels += most > static_cast<double>(threshold) ? 1 : 0;
            result.nan_pixels += has_nan(left) || has_nan(right) ? 1 : 0;
            if (most > result.max) {
                result.max = most;
                result.worst_column = column;
                result.worst_row = row;
            }
        }
    }
    result.rmse = std::sqrt(sum_of_squares / (3.0 * static_cast<double>(result.pixels)));
    return result;
}

} // namespace raysteps
