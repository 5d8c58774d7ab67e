// What checkpoints are made of: numbers as bits, the numbers beside a number, and sizes far apart.

uint bits(real value) {
    return floatBitsToUint(float(value));
}

uvec4 bits_of_point(real3 point, int number) {
    return uvec4(bits(point.x), bits(point.y), bits(point.z), uint(number));
}

uvec4 bits_of_point(real3 point, real number) {
    return uvec4(bits(point.x), bits(point.y), bits(point.z), bits(number));
}

bool is_finite(real x) {
    return abs(x) <= real(farthest);
}

// The next number away from zero, and towards it. Of zero, the least that no platform takes for
// zero.
const float least_number = 1.17549435e-38f; // 2^-126

real away_from_zero(real x) {
    return x == real(0.0f) ? real(least_number)
                           : real(uintBitsToFloat(floatBitsToUint(float(x)) + 1u));
}

real towards_zero(real x) {
    return real(uintBitsToFloat(floatBitsToUint(float(x)) - 1u));
}

// What is not finite stays.
real just_above(real x) {
    if (!is_finite(x)) {
        return x;
    }
    return x < real(0.0f) ? towards_zero(x) : away_from_zero(x);
}

real just_below(real x) {
    if (!is_finite(x)) {
        return x;
    }
    return x > real(0.0f) ? towards_zero(x) : -away_from_zero(-x);
}

// Of step 1, 2, 3, 4: powers of two, so that what is multiplied by one and divided by it again is
// the same to the bit. An epsilon is too large for the one, or too small for the other.
real scale_of(int step) {
    return real(step == 2   ? 9.5367431640625e-7f
                : step == 3 ? 1048576.0f
                : step == 4 ? 9.094947017729282e-13f
                            : 1.0f);
}
