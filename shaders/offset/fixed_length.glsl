// A fixed length along the normal, in the units of the scene, whatever they are.
const float leaving_t_min = 0.0f;
const float leaving_length = 1e-4f;

real3 leaving_point(SurfacePoint from) {
    precise real3 moved = from.point + real(leaving_length) * from.normal;
    return moved;
}
