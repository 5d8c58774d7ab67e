// Products of vectors, written out: GLSL's own may round as a driver likes, and these round the
// same on a GPU and in C++. `precise` forbids to fuse or reorder.

real dot_product(real3 a, real3 b) {
    precise real sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

real3 cross_product(real3 a, real3 b) {
    //# exercise 2.1: the cross product
    precise real x = a.y * b.z - a.z * b.y;
    precise real y = a.z * b.x - a.x * b.z;
    precise real z = a.x * b.y - a.y * b.x;
    //# stub: real x = real(0.0f);
    //# stub: real y = real(0.0f);
    //# stub: real z = real(0.0f);
    //# end
    return real3(x, y, z);
}

bool is_zero(real3 a) {
    return a.x == real(0.0f) && a.y == real(0.0f) && a.z == real(0.0f);
}

// The vector of length 1 in the same direction; of the zero vector, NaN.
// Scaled first, so that no square is too large or too small for the numbers at hand.
real3 unit(real3 a) {
    real largest = max(abs(a.x), max(abs(a.y), abs(a.z)));
    precise real3 scaled = a / largest;
    precise real length_of_scaled = sqrt(dot_product(scaled, scaled));
    precise real3 result = scaled / length_of_scaled;
    return result;
}
