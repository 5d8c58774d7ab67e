#pragma once

#include "basics/ray.h"
#include "mirror/glsl_language.h"
#include "scene/pack_scene.h"
#include "scene/scene.h"

#include <vector>

namespace raysteps::mirror {

// The buffers of a scene, exactly as upload gives them to the GPU. Must outlive the mirrors that
// read it.
struct SceneBuffers {
    explicit SceneBuffers(const Scene& scene)
        : corners(pack_vectors(scene.corners)), normals(pack_vectors(scene.normals)),
          triangle_materials(scene.triangle_materials), materials(pack_materials(scene.materials)) {
    }

    std::vector<vec4> corners;
    std::vector<vec4> normals;
    std::vector<std::int32_t> triangle_materials;
    std::vector<vec4> materials;
};

// Gives a mirror the buffers of the scene. A mirror of the loop over every triangle is then
// complete; others need their structure too.
template <class Mirror>
Mirror mirror_of(const SceneBuffers& buffers) {
    Mirror mirror{};
    mirror.triangle_corners.texels = buffers.corners;
    mirror.triangle_normals.texels = buffers.normals;
    mirror.triangle_materials.texels = buffers.triangle_materials;
    mirror.materials.texels = buffers.materials;
    if constexpr (requires { mirror.triangle_count; }) {
        mirror.triangle_count = static_cast<int>(buffers.corners.size() / 3);
    }
    return mirror;
}

// Rays, hits and views of a mirror differ from those of files and textures only in their type.
template <class Mirror>
typename Mirror::Ray to_mirror(const Ray& ray) {
    using Real3 = typename Mirror::real3;
    return {Real3(ray.origin), Real3(ray.direction), ray.t_min, ray.t_max};
}

template <class Mirror>
typename Mirror::View to_mirror(const View& view) {
    using Real3 = typename Mirror::real3;
    return {Real3(view.eye), Real3(view.lower_left), Real3(view.right), Real3(view.up)};
}

template <class MirrorHit>
Hit from_mirror(const MirrorHit& hit) {
    return {static_cast<float>(hit.t), static_cast<float>(hit.u), static_cast<float>(hit.v),
            hit.triangle};
}

} // namespace raysteps::mirror
