// What roulette leaves of a path: its weight, and whether it goes on. The weight is the origin, the
// chance to go on and the number drawn are the direction's x and y, without sign and whole part;
// the chance is at least 1 / 16.
#include "light/samples.glsl"

#include "light/path.glsl"

uvec4 checkpoint(Ray ray, int step) {
    PathStep before;
    before.ray = ray;
    before.ray.t_min = real(0.0f);
    before.ray.t_max = real(farthest);
    before.weight = ray.origin;
    before.density = real(0.25f);
    real chance = max(fraction_of(abs(ray.direction.x)), real(0.0625f));
    PathStep next = after_roulette(before, chance, fraction_of(abs(ray.direction.y)));
    bool ended = next.ray.t_max < next.ray.t_min;
    return ended ? uvec4(0u) : bits_of_point(next.weight, 1);
}
