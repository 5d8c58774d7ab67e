#include "render/show_rays.h"

#include "gpu/draw.h"
#include "render/picture.h"

namespace raysteps {

Image show_directions(const RayTextures& rays) {
    Program program("pass/show_directions.frag");
    program.set("ray_directions", rays.directions);
    const Texture colors(TexelFormat::rgba32f, rays.directions.width(), rays.directions.height());
    draw(program, {.textures = {colors}});
    return read_image(colors);
}

} // namespace raysteps
