#include "program/show_trace.h"

#include "program/deliver.h"
#include "program/timed_trace.h"
#include "program/tracing_options.h"
#include "basics/error.h"
#include "gpu/shaders.h"
#include "image/heat_map.h"
#include "render/rays.h"
#include "render/show_hits.h"
#include "measure/statistics.h"

#include <algorithm>
#include <iterator>

namespace raysteps {

namespace {

enum class Counted { nothing, visits, tests };

Counted counted_in(const std::string& view) {
    if (view == "visits") {
        return Counted::visits;
    }
    return view == "tests" ? Counted::tests : Counted::nothing;
}

std::string title_of(Counted counted, const std::string& structure) {
    return structure + (counted == Counted::visits ? ": cells or nodes visited a ray"
                                                   : ": triangles tested a ray");
}

// From 0 to what 99 in 100 of the rays that did anything stay below: a few rays along a silhouette
// do many times more, and would leave the rest in the dark. The legend counts them.
HeatMapRange range_of_most(std::span<const float> values) {
    std::vector<float> some;
    std::copy_if(values.begin(), values.end(), std::back_inserter(some),
                 [](float value) { return value > 0.0f; });
    if (some.empty()) {
        return {};
    }
    return {.lower = 0.0f, .upper = static_cast<float>(summarize(some).percentile_99)};
}

// Texels come bottom row first, a heat map wants the top one first.
Image heat_map_of(const Texture& observations, Counted counted, const std::string& structure) {
    const std::vector<glm::uvec4> texels = read_integers(observations);
    const int width = observations.width();
    const int height = observations.height();
    std::vector<float> values;
    values.reserve(texels.size());
    for (int row = height - 1; row >= 0; --row) {
        for (int column = 0; column < width; ++column) {
            const glm::uvec4& texel =
                texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)];
            values.push_back(static_cast<float>(counted == Counted::visits ? texel.x : texel.y));
        }
    }
    return heat_map(values, width, height, range_of_most(values), title_of(counted, structure));
}

} // namespace

void add_view_option(CLI::App& app, std::string& view) {
    std::string names;
    for (const NamedPart& part : list_parts("view")) {
        names += part.name + ", ";
    }
    app.add_option("--view", view, names + "visits or tests (heat maps)")->capture_default_str();
}

void show_trace(const Command& command, const std::string& view) {
    Parts parts = trace_parts(command);
    const Counted counted = counted_in(view);
    if (counted == Counted::visits && command.structure == "every_triangle") {
        throw InputError("--view visits: the loop over every triangle visits no cells. Take --view "
                         "tests, or another --structure.");
    }
    const std::string view_part = counted == Counted::nothing ? find_part("view", view) : "";
    const Scene scene = open_scene(command);
    const auto context = open_context(command);
    if (!command.rays.empty()) {
        trace_ray_file(command, parts, scene);
        return;
    }
    if (counted != Counted::nothing) {
        parts["observer"] = "observer/count.glsl";
    }
    const SceneTextures textures = upload(scene, build_structure(command, scene));
    TimedTrace trace(command, parts, textures);
    const std::string name = picture_name(command) + "_" + command.structure + "_" + view;
    deliver(
        command, *context, scene.camera, name, [&](const Camera& camera, int width, int height) {
            const RayTextures rays = generate_rays(camera, width, height, RayGeneration::direct);
            const Texture hits = trace.closest_hits(rays, static_cast<std::size_t>(width) *
                                                              static_cast<std::size_t>(height));
            if (counted != Counted::nothing) {
                return heat_map_of(*trace.observations(), counted, command.structure);
            }
            return show_hits(rays, hits, textures, camera, scene.background, view_part);
        });
    trace.report();
}

} // namespace raysteps
