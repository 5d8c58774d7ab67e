// A point on a triangle (a, b, c), as it was computed, and the triangle's unit normal.
struct SurfacePoint {
    real3 a;
    real3 b;
    real3 c;
    real3 point;
    real3 normal;
};
