// Up to 256 units in the last place of each coordinate along the normal, by counting up the bits of
// the number as an integer; near zero, where these units are tiny, a fixed length. Source: Wächter
// and Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019.
const float leaving_t_min = 0.0f;
const float near_zero = 0.03125f;                 // 1 / 32
const float length_near_zero = 1.52587890625e-5f; // 1 / 65536
const float last_places = 256.0f;

real moved_along(real coordinate, real normal) {
    //# exercise 8.2: an offset in units of the last place
    int places = int(real(last_places) * normal);
    int bits = floatBitsToInt(float(coordinate));
    bits = coordinate < real(0.0f) ? bits - places : bits + places;
    precise real near = coordinate + real(length_near_zero) * normal;
    return abs(coordinate) < real(near_zero) ? near : real(intBitsToFloat(bits));
    //# stub: return coordinate;
    //# end
}

real3 leaving_point(SurfacePoint from) {
    return real3(moved_along(from.point.x, from.normal.x), moved_along(from.point.y, from.normal.y),
                 moved_along(from.point.z, from.normal.z));
}
