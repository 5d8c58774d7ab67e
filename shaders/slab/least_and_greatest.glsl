// The slab test that is told most often: both planes of an axis, the least and the greatest of
// their distances, and 1 / 0 is infinite. A ray in the plane of a side makes 0 * infinity, which is
// no number, and what min and max do with that, each platform decides by itself.
struct SlabRay {
    real3 origin;
    real3 inverse;
    real t_min;
    real t_max;
};

SlabRay prepare_slab_ray(Ray ray) {
    SlabRay prepared;
    precise real3 inverse = real3(real(1.0f)) / ray.direction;
    prepared.origin = ray.origin;
    prepared.inverse = inverse;
    prepared.t_min = ray.t_min;
    prepared.t_max = ray.t_max;
    return prepared;
}

bool meets_slabs(SlabRay slabs, real3 lower, real3 upper) {
    precise real3 first = (lower - slabs.origin) * slabs.inverse;
    precise real3 second = (upper - slabs.origin) * slabs.inverse;
    real3 enters = min(first, second);
    real3 leaves = max(first, second);
    real entry = max(max(enters.x, enters.y), max(enters.z, slabs.t_min));
    real exit = min(min(leaves.x, leaves.y), min(leaves.z, slabs.t_max));
    return entry <= exit;
}
