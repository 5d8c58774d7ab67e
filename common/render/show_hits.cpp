#include "render/show_hits.h"

#include "gpu/draw.h"

#include <glm/geometric.hpp>

namespace raysteps {

Image read_image(const Texture& texture) {
    const std::vector<glm::vec4> texels = read_floats(texture);
    Image image(texture.width(), texture.height());
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const auto from_bottom = static_cast<std::size_t>(image.height - 1 - row);
            image.at(column, row) =
                glm::vec3(texels[from_bottom * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(column)]);
        }
    }
    return image;
}

Image show_directions(const RayTextures& rays) {
    Program program("pass/show/show_directions.frag");
    program.set("ray_directions", rays.directions);
    const Texture colors(TexelFormat::rgba32f, rays.directions.width(), rays.directions.height());
    draw(program, {.textures = {colors}});
    return read_image(colors);
}

Image show_hits(const RayTextures& rays, const Texture& hits, const SceneTextures& scene,
                const Camera& camera, const glm::vec3& background, const std::string& view_part) {
    Program program("pass/show/show_hits.frag", {{"view", view_part}});
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
