// A ray that starts on a triangle must not hit it again (acne), nor skip what lies close behind
// (a leak): its origin is moved off the plane, by as little as rounding allows.
//
// With e = 2^-24 and M the largest coordinate of the corners: a point a + u * (b - a) + v * (c - a)
// is computed to within 12 e M in each coordinate (edges are at most 2M long; six roundings of at
// most that), so to within 21 e M along a unit normal. The triangle test of the new ray sees
// differences of numbers up to 2M, and weighs three of them: 9 roundings more, 18 e M in each
// coordinate, 31 e M along the normal. 64 e M is over the sum of both for rays that do not graze;
// for those that do, tests/chapters/03_shading counts. A neighbour is covered where its coordinates
// are no larger: a small triangle that lies on a much larger one, in its plane, can still see it.
// Source of the idea: Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd ed., 2016,
// section 3.9.

const float rounding_unit = 5.9604644775390625e-8f; // 2^-24

//# exercise 3.6: a hunt, for spots of shadow
real largest_coordinate(real3 p) {
    return max(abs(p.x), max(abs(p.y), abs(p.z)));
}

// How far an origin on the triangle (a, b, c) is moved along the unit normal.
real leaving_distance(real3 a, real3 b, real3 c) {
    real largest = max(largest_coordinate(a), max(largest_coordinate(b), largest_coordinate(c)));
    return real(64.0f * rounding_unit) * largest;
}
//# end
