// A difference of two products without the errors of the products: what rounding takes from each
// is computed too, and given back. Source: Dekker, "A Floating-Point Technique for Extending the
// Available Precision", 1971.

// The upper and the lower half of a number's digits: high + low is the number, and products of
// halves are exact.
struct Halves {
    real high;
    real low;
};

Halves halves(real a) {
    precise real scaled = a * split_factor;
    precise real high = scaled - (scaled - a);
    precise real low = a - high;
    Halves result;
    result.high = high;
    result.low = low;
    return result;
}

// What is missing from the rounded product of a and b. Where the product is so small that the
// missing part would be lost itself, it is taken for zero: the product then counts as it is.
real missing_part(real product, Halves a, Halves b) {
    precise real missing =
        ((a.high * b.high - product) + a.high * b.low + a.low * b.high) + a.low * b.low;
    return abs(product) > least_product ? missing : real(0.0f);
}

// a.x * b.y - a.y * b.x: twice the area of the triangle (origin, a, b) in the plane. It has the
// sign of the true area and differs from it by at most 4 roundings: where the products are nearly
// equal, the sums below are exact, and elsewhere nothing cancels. With products under least_product
// it still has the sign, or is zero.
real exact_area(real3 a, real3 b, Halves ax, Halves ay, Halves bx, Halves by) {
    precise real first = a.x * b.y;
    precise real second = a.y * b.x;
    precise real area =
        ((first - second) + missing_part(first, ax, by)) - missing_part(second, ay, bx);
    return area;
}
