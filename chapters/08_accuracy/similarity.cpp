#include "similarity.h"

#include "basics/error.h"
#include "image/color.h"

#include <algorithm>

namespace raysteps {

namespace {

constexpr int window = 8;
constexpr double window_pixels = window * window;

// The constants of the source, for brightness from 0 to 1.
constexpr double steady_mean = 0.01 * 0.01;
constexpr double steady_variance = 0.03 * 0.03;

// Rec. 709.
double brightness(const glm::vec3& color) {
    const float linear = 0.2126f * color.x + 0.7152f * color.y + 0.0722f * color.z;
    return static_cast<double>(srgb_from_linear(std::clamp(linear, 0.0f, 1.0f)));
}

double similarity_of_windows(const Image& a, const Image& b, int column, int row) {
    double sum_a = 0.0;
    double sum_b = 0.0;
    double sum_aa = 0.0;
    double sum_bb = 0.0;
    double sum_ab = 0.0;
    for (int y = row; y < row + window; ++y) {
        for (int x = column; x < column + window; ++x) {
            const double p = brightness(a.at(x, y));
            const double q = brightness(b.at(x, y));
            sum_a += p;
            sum_b += q;
            sum_aa += p * p;
            sum_bb += q * q;
            sum_ab += p * q;
        }
    }
    const double mean_a = sum_a / window_pixels;
    const double mean_b = sum_b / window_pixels;
    const double variance_a = sum_aa / window_pixels - mean_a * mean_a;
    const double variance_b = sum_bb / window_pixels - mean_b * mean_b;
    const double covariance = sum_ab / window_pixels - mean_a * mean_b;
    return (2.0 * mean_a * mean_b + steady_mean) * (2.0 * covariance + steady_variance) /
           ((mean_a * mean_a + mean_b * mean_b + steady_mean) *
            (variance_a + variance_b + steady_variance));
}

} // namespace

double structural_similarity(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.width < window || a.height < window) {
        throw InputError("Pictures of " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                         " and " + std::to_string(b.width) + "x" + std::to_string(b.height) +
                         " pixels cannot be compared. Give two of one size, 8x8 at least.");
    }
    double sum = 0.0;
    double windows = 0.0;
    for (int row = 0; row + window <= a.height; row += window / 2) {
        for (int column = 0; column + window <= a.width; column += window / 2) {
            sum += similarity_of_windows(a, b, column, row);
            windows += 1.0;
        }
    }
    return sum / windows;
}

} // namespace raysteps
