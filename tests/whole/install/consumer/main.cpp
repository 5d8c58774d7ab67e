// A program of somebody else's, against an installed Raysteps: a tree, a ray through it by the
// mirror, the same by exact arithmetic, and a shader program.
#include <gpu/context.h>
#include <gpu/shaders.h>
#include <mirror/trace_by_mirror.h>
#include <reference/exact.h>
#include <scene/scene.h>
#include <structure/bvh/build_bvh.h>
#include <structure/bvh/check_bvh.h>

#include <iostream>

int main() {
    using namespace raysteps;
    Scene scene;
    scene.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    scene.normals = scene.corners;
    scene.triangle_materials = {0, 0};
    scene.materials.emplace_back();
    const Bvh bvh = build_bvh(scene.corners, {});
    const Ray ray{{0.25f, 0.25f, 3}, {0, 0, -1}, 0, 10};
    const mirror::SceneBuffers buffers(scene);
    const auto hits =
        mirror_walks().at("bvh_ordered")(buffers, pack(bvh, scene.corners), std::span(&ray, 1));
    const auto exact =
        exact_intersection(ray, {scene.corners[3], scene.corners[4], scene.corners[5]});
    const auto context = make_context(ContextKind::automatic);
    const bool shaders = read_shader("pass/full_screen.vert", {}, SHADERS).text.size() > 20;
    std::cout << check_bvh(bvh, scene.corners).size() << " faults, triangle " << hits[0].triangle
              << " at " << hits[0].t << ", exact " << exact.t << ", shaders " << shaders << "\n";
    return hits[0].triangle == 1 && hits[0].t == 2.0f && exact.hit && shaders ? 0 : 1;
}
