// The same with an exit that is 4 units in the last place later.
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/box_padded.glsl"
#include "slab/near_planes.glsl"

struct SlabRay {
    BoxRay ray;
    real t_max;
};

SlabRay prepare_slab_ray(Ray ray) {
    SlabRay prepared;
    prepared.ray = box_ray(ray);
    prepared.t_max = ray.t_max;
    return prepared;
}

bool meets_slabs(SlabRay slabs, real3 lower, real3 upper) {
    return meets_box(slabs.ray, near_planes(slabs.ray, lower, upper),
                     near_planes(slabs.ray, upper, lower), slabs.t_max);
}
