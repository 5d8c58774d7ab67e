// The ray starts at the point that was computed: on one side of the triangle or the other.
const float leaving_t_min = 0.0f;

real3 leaving_point(SurfacePoint from) {
    return from.point;
}
