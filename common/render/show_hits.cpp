#include "render/show_hits.h"

#include "gpu/draw.h"
#include "render/picture.h"

#include <glm/geometric.hpp>

namespace raysteps {

Image show_hits(const RayTextures& rays, const Texture& hits, const SceneTextures& scene,
                const Camera& camera, const glm::vec3& background, const std::string& view_part) {
    Program program("pass/show_hits.frag", {{"view", view_part}});
    program.set("ray_origins", rays.origins)
        .set("ray_directions", rays.directions)
        .set("hits", hits)
        .set("triangle_corners", scene.corners)
        .set("triangle_normals", scene.normals)
        .set("triangle_materials", scene.triangle_materials)
        .set("materials", scene.materials)
        .set("middle_distance", glm::distance(camera.eye, camera.target))
        .set("background", background);
    const Texture colors(TexelFormat::rgba32f, hits.width(), hits.height());
    draw(program, {.textures = {colors}});
    return read_image(colors);
}

} // namespace raysteps
