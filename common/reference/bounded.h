#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace raysteps {

// Doubles that know how wrong they are, so that exact arithmetic is asked only where they cannot
// decide. What an operation loses is known to the last bit (Dekker, "A floating-point technique for
// extending the available precision", 1971), so that what is exact has the error 0.

// The true number is within `error` of `value`, where a ten-thousandth more pays for rounding the
// errors themselves. Numbers made of a few products of floats neither overflow nor underflow.
struct Bounded {
    double value = 0.0;
    double error = 0.0;
};

inline constexpr double rounded_errors = 1.0001;

inline Bounded operator+(const Bounded& a, const Bounded& b) {
    const double sum = a.value + b.value;
    const double added = sum - a.value;
    const double lost = (a.value - (sum - added)) + (b.value - added);
    return {sum, a.error + b.error + std::abs(lost)};
}

inline Bounded operator-(const Bounded& a) {
    return {-a.value, a.error};
}

inline Bounded operator-(const Bounded& a, const Bounded& b) {
    return a + -b;
}

// The upper half of the digits.
inline double upper_digits(double a) {
    const double large = 134217729.0 * a; // 2^27 + 1
    return large - (large - a);
}

inline Bounded operator*(const Bounded& a, const Bounded& b) {
    const double product = a.value * b.value;
    const double a_upper = upper_digits(a.value);
    const double b_upper = upper_digits(b.value);
    const double a_lower = a.value - a_upper;
    const double b_lower = b.value - b_upper;
    const double lost = a_lower * b_lower -
                        (((product - a_upper * b_upper) - a_lower * b_upper) - a_upper * b_lower);
    return {product,
            std::abs(a.value) * b.error + (std::abs(b.value) + b.error) * a.error + std::abs(lost)};
}

inline Bounded times_power_of_two(const Bounded& a, double power) {
    return {a.value * power, a.error * power};
}

inline Bounded size_of(const Bounded& a) {
    return {std::abs(a.value), a.error};
}

inline Bounded lesser(const Bounded& a, const Bounded& b) {
    return {std::min(a.value, b.value), std::max(a.error, b.error)};
}

inline Bounded greater(const Bounded& a, const Bounded& b) {
    return {std::max(a.value, b.value), std::max(a.error, b.error)};
}

// -1, 0 or +1; nothing where the error leaves it open.
inline std::optional<int> sure_sign(const Bounded& a) {
    const double room = rounded_errors * a.error;
    if (a.value > room) {
        return 1;
    }
    if (a.value < -room) {
        return -1;
    }
    return room == 0.0 ? std::optional<int>(0) : std::nullopt;
}

// A number lies between two doubles, both included.
struct Between {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

// The sign of the denominator is sure, and not 0.
inline Between quotient(const Bounded& numerator, const Bounded& denominator) {
    const double middle = numerator.value / denominator.value;
    const double least = std::abs(denominator.value) - rounded_errors * denominator.error;
    const double error =
        rounded_errors * (numerator.error + std::abs(middle) * denominator.error) / least +
        0x1p-51 * std::abs(middle);
    return {middle - error, middle + error};
}

using BoundedPoint = std::array<Bounded, 3>;

inline Bounded dot(const BoundedPoint& a, const BoundedPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace raysteps
