#pragma once

#include "render/scene_textures.h"
#include "scene/scene.h"

#include <map>
#include <memory>
#include <string>

namespace raysteps {

// A scene to compare methods on. Up to most_triangles_of_loop triangles, rays are tested against
// every one of them, so that all methods make the same tests; more are walked by bvh_ordered.
struct Subject {
    Scene scene;
    std::string structure; // the part's file
    std::shared_ptr<const SceneTextures> textures;
};

inline constexpr int most_triangles_of_loop = 600;

// Origins are expected at most so far from the corners (structure/padding.h). A context must be
// current as long as it lives.
std::shared_ptr<const Subject> make_subject(Scene scene, float reach);

// A small closed mesh: a sphere of 320 triangles around a point off the origin.
std::shared_ptr<const Subject> usual_subject();

// Needles in all directions, up to five thousand times as long as wide.
std::shared_ptr<const Subject> slivers_subject();

// The scene's triangles in a structure, built with these values.
std::shared_ptr<const SceneTextures>
build_textures(const Scene& scene, const std::string& structure, float reach,
               const std::map<std::string, std::string>& values);

// What the map of triangles to a unit triangle is, for shaders/exhibit/transforms.glsl: three rows a
// triangle, computed in double. Of a triangle without an area, rows that are not finite.
std::vector<glm::vec4> triangle_transforms(std::span<const glm::vec3> corners);

} // namespace raysteps
