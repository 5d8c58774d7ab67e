// Hits nearer than a fixed number do not count: a length in the units of the scene, whatever they
// are.
const float leaving_t_min = 1e-4f;

real3 leaving_point(SurfacePoint from) {
    return from.point;
}
