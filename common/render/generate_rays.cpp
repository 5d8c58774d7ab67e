#include "render/generate_rays.h"

#include "gpu/draw.h"
#include "scene/view.h"

namespace raysteps {

namespace {

void set_view(Program& program, const View& view) {
    program.set("view.eye", view.eye)
        .set("view.lower_left", view.lower_left)
        .set("view.right", view.right)
        .set("view.up", view.up);
}

} // namespace

RayTextures generate_rays(const Camera& camera, int width, int height, RayGeneration generation) {
    Program program(generation == RayGeneration::interpolated ? "pass/interpolate_rays.frag"
                                                              : "pass/compute_rays.frag");
    set_view(program, view_of(camera, static_cast<double>(width) / height));
    program.set("picture_size", glm::vec2(width, height));
    RayTextures rays = make_ray_textures(width, height);
    const Shape shape =
        generation == RayGeneration::interpolated ? Shape::rectangle : Shape::triangle;
    draw(program, {.textures = {rays.origins, rays.directions}, .shape = shape});
    return rays;
}

} // namespace raysteps
