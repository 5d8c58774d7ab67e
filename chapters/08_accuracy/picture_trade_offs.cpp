#include "trade_offs.h"

#include "judges.h"
#include "render/trace_rays.h"
#include "render/whitted_renderer.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "structure/padding.h"
#include "structure/structure.h"

#include <glm/geometric.hpp>

#include <memory>

namespace raysteps {

namespace {

constexpr int usual_depth = 4; // mirrors, where another thing is compared
constexpr int true_depth = 32;
constexpr int true_lamp_side = 8;   // points along each side of the lamp
constexpr float lamp_share = 0.25f; // side of a lamp over its distance from what is looked at

// A scene that can be rendered, and how.
class Photographer {
public:
    Photographer(Scene scene, const Effort& effort)
        : scene_(std::move(scene)), size_(effort.picture_size),
          renderer_(scene_, textures_of(scene_), walk_parts("watertight", "fastest"),
                    effort.limits) {}

    // The mean of side * side rays a pixel.
    Image render(int side, int depth) {
        const Image fine = renderer_.render(scene_.camera, side * size_, side * size_, depth);
        Image picture(size_, size_);
        for (int row = 0; row < side * size_; ++row) {
            for (int column = 0; column < side * size_; ++column) {
                picture.at(column / side, row / side) +=
                    fine.at(column, row) / static_cast<float>(side * side);
            }
        }
        return picture;
    }

private:
    static SceneTextures textures_of(const Scene& scene) {
        const float reach = reach_of(origins_of(scene.camera), scene.corners);
        return upload(scene, family_of("fastest").build(scene.corners, {reach, {}}));
    }

    Scene scene_;
    int size_;
    WhittedRenderer renderer_;
};

// The scene with its lights spread over squares that lie flat, as lamps on a ceiling do.
Scene with_lamps(Scene scene, int side) {
    std::vector<Light> points;
    for (const Light& light : scene.lights) {
        const float length = lamp_share * glm::distance(scene.camera.target, light.position);
        for (int i = 0; i < side * side; ++i) {
            const float x = (static_cast<float>(i % side) + 0.5f) / static_cast<float>(side) - 0.5f;
            const float y = (static_cast<float>(i / side) + 0.5f) / static_cast<float>(side) - 0.5f;
            points.push_back({light.position + length * glm::vec3(x, 0.0f, y),
                              light.color / static_cast<float>(side * side)});
        }
    }
    scene.lights = points;
    return scene;
}

using Render = std::function<Image()>;

// One setting of a trade_off: the first one's picture and where it is wrong are kept to be shown.
void add_setting(TradeOffTrials& trade_off, const std::string& method, const Render& render,
                 const std::shared_ptr<const Image>& truth) {
    const Image picture = render();
    if (trade_off.pictures.empty()) {
        trade_off.pictures.push_back({"truth", *truth});
        trade_off.pictures.push_back({method, picture});
    }
    trade_off.pictures.push_back(
        {method + ": visibly different", mark_differences(picture, *truth)});
    trade_off.trials.push_back(
        {.method = method,
         .family = "camera",
         .timed_cases = picture.pixels.size(),
         .run = [render] { render(); },
         .examine = [render, truth] { return judge_picture(render(), *truth); }});
}

TradeOffTrials picture_trade_off(const std::string& name, const std::string& question) {
    TradeOffTrials trade_off;
    trade_off.name = name;
    trade_off.question = question;
    trade_off.unit_of_cases = "pixel";
    trade_off.unit_of_error = "a pixel, in steps of sRGB";
    trade_off.kind = TradeOffKind::pictures;
    return trade_off;
}

} // namespace

TradeOffTrials samples_trade_off(const Effort& effort) {
    TradeOffTrials trade_off =
        picture_trade_off("samples a pixel", "How many rays does a pixel need? On mirrors.");
    const auto by = std::make_shared<Photographer>(load_scene("mirrors", 1.0f), effort);
    const auto truth =
        std::make_shared<const Image>(by->render(2 * effort.most_samples, usual_depth));
    for (int side = 1; side <= effort.most_samples; ++side) {
        add_setting(
            trade_off, std::to_string(side * side) + (side == 1 ? " sample" : " samples"),
            [by, side] { return by->render(side, usual_depth); }, truth);
    }
    return trade_off;
}

TradeOffTrials depth_trade_off(const Effort& effort) {
    TradeOffTrials trade_off =
        picture_trade_off("depth", "How many mirrors must a path follow? On mirrors.");
    const auto by = std::make_shared<Photographer>(load_scene("mirrors", 1.0f), effort);
    const auto truth = std::make_shared<const Image>(by->render(1, true_depth));
    for (const int depth : {0, 1, 2, 4, 8}) {
        add_setting(
            trade_off, std::to_string(depth) + (depth == 1 ? " mirror" : " mirrors"),
            [by, depth] { return by->render(1, depth); }, truth);
    }
    return trade_off;
}

TradeOffTrials lamp_trade_off(const Effort& effort) {
    TradeOffTrials trade_off = picture_trade_off(
        "points of a lamp", "How many points must stand for a lamp with an area? On cornell_box.");
    const Scene scene = load_scene("cornell_box", 1.0f);
    Photographer judge(with_lamps(scene, true_lamp_side), effort);
    const auto truth = std::make_shared<const Image>(judge.render(1, usual_depth));
    for (const int side : {1, 2, 4}) {
        const auto by = std::make_shared<Photographer>(with_lamps(scene, side), effort);
        add_setting(
            trade_off, std::to_string(side * side) + (side == 1 ? " point" : " points"),
            [by] { return by->render(1, usual_depth); }, truth);
    }
    return trade_off;
}

} // namespace raysteps
