#version 410 core
// A ray through another place of the pixel for each sample, and what its path counts at first.
#include <real>
#include "core/ray.glsl"
#include "core/hit.glsl"
#include "core/texels.glsl"
#include "core/view.glsl"
#include "core/hit_texels.glsl"
#include "core/triangles.glsl"
#include "light/materials.glsl"
#include "core/vector.glsl"
#include "light/samples.glsl"
#include "light/path.glsl"
#include "light/hash.glsl"
#include <random>

uniform View view;

layout(location = 0) out vec4 ray_origin;
layout(location = 1) out vec4 ray_direction;
layout(location = 2) out vec4 weight; // and in w the density of the ray's direction

void main() {
    PathSample path = sample_at(int(gl_FragCoord.x), int(gl_FragCoord.y));
    SquarePoint place = random_point(path.pixel, path.sample_number, 0);
    Ray ray = primary_ray(view, (float(path.column) + place.x) / float(picture_width),
                          (float(path.row) + place.y) / float(picture_height));
    ray_origin = pack_ray_origin(ray);
    ray_direction = pack_ray_direction(ray);
    weight = vec4(1.0, 1.0, 1.0, 0.0);
}
