// Chapter 10: what makes a walk fast, step by step, and Embree beside it.
// load_scene -> climb -> table, chart; VisitCounter -> draw_blocks -> picture
#include "climb_report.h"
#include "program/figures.h"
#include "program/show.h"

#include <iostream>

using namespace raysteps;

namespace {

const std::vector<std::string> full_scenes{"bunny", "knot:8", "stadium:8", "sphereflake:4",
                                           "mount:8"};
constexpr int full_side = 512;

// The walks whose blocks are drawn: the first and the last that an observer can watch.
const std::vector<std::string> drawn_walks{"bvh_skip", "bvh4"};

// Writes the picture of what lanes do, or shows it in the window.
void draw_rounds(const PictureOptions& picture, Context& context, const Scene& scene,
                 const Limits& limits, const std::map<std::string, std::string>& build_values) {
    VisitCounter counter(scene, drawn_walks, limits, build_values);
    show_or_write(picture, context, scene.camera, "rounds",
                  [&](const Camera& camera, int width, int height) {
                      return draw_blocks(counter.count(camera, width, height));
                  });
}

} // namespace

int main(int argc, char** argv) {
    Options options("10_speed",
                    "Chapter 10: what makes a walk fast, step by step, and Embree beside it.");
    PictureOptions picture{.scene = "bunny", .size = {256, 256}};
    std::vector<std::string> scenes;
    ClimbRequest request;
    std::string embree = "auto";
    bool full = false;
    add_picture_options(options, picture);
    options.list("--scenes", scenes, "the scenes to climb in, between commas, in place of --scene");
    options.flag("--full", full,
                 "five scenes (bunny, knot:8, stadium:8, sphereflake:4, mount:8) at 512 x 512: "
                 "takes about a minute");
    options.number("--rounds", request.rounds,
                   "how often each step is measured, after one round that is dropped", 1, 1000);
    options.text("--embree", embree, "auto, robust, fast or off");
    options.value("--tree", "", "climb in the tree of this file (docs/tree_files.md)",
                  [&](const std::string& file) { request.build_values["tree"] = file; });
    options.excludes("--full", {"--scene", "--scenes", "--window", "--tree"});
    options.excludes("--scenes", {"--scene", "--window", "--tree"});
    return options.run(argc, argv, [&] {
        if (full) {
            scenes = full_scenes;
            picture.size =
                options.given("--size") ? picture.size : PictureSize{full_side, full_side};
        } else if (scenes.empty()) {
            scenes = {picture.scene};
        }
        request.embree = parse_embree(embree);
        request.width = picture.size.width;
        request.height = picture.size.height;
        const Scene first = load_scene(picture, scenes.front());
        const auto context = open_context(picture);
        const Limits limits = measure_limits();
        draw_rounds(picture, *context, first, limits, request.build_values);
        if (picture.window) {
            return;
        }
        std::map<std::string, TraceRays> walks = make_step_walks(limits);
        std::vector<ClimbedScene> climbed;
        FiguresHead head{.schema = "climb.schema.json"};
        if (!request.build_values.empty()) {
            head.builders["bvh"] = request.build_values;
        }
        for (const std::string& name : scenes) {
            const Scene scene = name == scenes.front() ? first : load_scene(picture, name);
            head.scenes.push_back(record_of(scene));
            climbed.push_back(
                climb(scene, walks, limits, request, show_progress("climbing in " + name)));
            std::cout << to_table(climbed.back(), yardstick_of(request)) << std::flush;
        }
        draw_climb(picture.out / "climb.png", climbed, yardstick_of(request));
        print_written(picture.out / "climb.png");
        draw_lanes(picture.out / "lanes.png", climbed.front());
        print_written(picture.out / "lanes.png");
        write_figures(picture.json, head, to_numbers(climbed, request));
    });
}
