// A slab test that saves a subtraction a plane: plane * inverse - origin * inverse, where the
// second product is made once a ray. It is rounded by the size of the coordinates, not by that of
// the distance, so far from zero it misses boxes, and what cancels is lost.
#include "structure/bvh/box_ray.glsl"
#include "slab/near_planes.glsl"

struct SlabRay {
    BoxRay ray;
    real3 first_shift;
    real3 last_shift;
    real t_max;
};

SlabRay prepare_slab_ray(Ray ray) {
    SlabRay prepared;
    prepared.ray = box_ray(ray);
    precise real3 first = prepared.ray.first_origin * prepared.ray.inverse;
    precise real3 last = prepared.ray.last_origin * prepared.ray.inverse;
    prepared.first_shift = first;
    prepared.last_shift = last;
    prepared.t_max = ray.t_max;
    return prepared;
}

bool meets_slabs(SlabRay slabs, real3 lower, real3 upper) {
    real3 inverse = slabs.ray.inverse;
    precise real3 enters = near_planes(slabs.ray, lower, upper) * inverse - slabs.first_shift;
    precise real3 leaves = near_planes(slabs.ray, upper, lower) * inverse - slabs.last_shift;
    real entry = max(max(enters.x, enters.y), max(enters.z, slabs.ray.t_min));
    real exit = min(min(leaves.x, leaves.y), min(leaves.z, slabs.t_max));
    return entry <= exit;
}
