#include "trade_offs.h"

#include "gpu/draw.h"
#include "gpu/gl.h"
#include "reference/reference_ray.h"
#include "render/rays.h"
#include "scene/view.h"

#include <memory>

namespace raysteps {

namespace {

// One way to make the rays of a picture; the program is compiled once.
class MakeRays {
public:
    MakeRays(const std::string& pass, Shape shape, const Camera& camera, int size)
        : program_(pass), shape_(shape), camera_(camera), size_(size),
          rays_(make_ray_textures(size, size)) {
        const View view = view_of(camera, 1.0);
        program_.set("view.eye", view.eye)
            .set("view.lower_left", view.lower_left)
            .set("view.right", view.right)
            .set("view.up", view.up)
            .set("picture_size", glm::vec2(size, size));
    }

    void run() {
        draw(program_, {.textures = {rays_.origins, rays_.directions}, .shape = shape_});
        glFinish();
    }
    Findings examine() const {
        return {{}, summarize(direction_errors(read_rays(rays_), camera_, size_, size_)), {}};
    }

private:
    Program program_;
    Shape shape_;
    Camera camera_;
    int size_;
    RayTextures rays_;
};

} // namespace

TradeOffTrials primary_trade_off(const Effort& effort) {
    TradeOffTrials trade_off;
    trade_off.name = "primary rays";
    trade_off.question = "Where do the rays of a picture come from?";
    trade_off.unit_of_cases = "ray";
    trade_off.unit_of_error = "direction, in ulp";
    const int size = 4 * effort.picture_size; // a pass that does so little needs more pixels
    for (const float angle : {20.0f, 60.0f, 120.0f}) {
        Camera camera;
        camera.eye = {1.3f, 0.7f, 4.1f};
        camera.target = {0.1f, -0.2f, 0.3f};
        camera.vertical_field_of_view = angle;
        const auto add = [&](const std::string& method, const std::string& pass, Shape shape) {
            const auto make = std::make_shared<MakeRays>(pass, shape, camera, size);
            trade_off.trials.push_back(
                {.method = method,
                 .family = std::to_string(static_cast<int>(angle)) + " degrees",
                 .timed_cases = static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                 .run = [make] { make->run(); },
                 .examine = [make] { return make->examine(); }});
        };
        add("interpolated", "pass/rays/interpolate_rays.frag", Shape::rectangle);
        add("direct", "pass/rays/compute_rays.frag", Shape::triangle);
    }
    return trade_off;
}

} // namespace raysteps
