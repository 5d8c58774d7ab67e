#include "trace/trace_options.h"
#include "scene/view.h"

#include "basics/error.h"
#include "gpu/limits.h"
#include "gpu/shaders.h"
#include "program/output.h"
#include "program/window/controls.h"
#include "render/trace_rays.h"
#include "structure/padding.h"

#include <cstdio>

namespace raysteps {

namespace {

void print_memory(const std::string& what) {
    std::printf("memory    %s\n", what.c_str());
    std::fflush(stdout);
}

void print_facts(const std::string& structure, const std::vector<Fact>& facts) {
    std::string line;
    for (const Fact& fact : facts) {
        line += (line.empty() ? "structure " + structure + ": " : ", ") + readable(fact);
    }
    if (!line.empty()) {
        std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    }
}

} // namespace

std::vector<std::string> part_names(const std::string& slot) {
    std::vector<std::string> names;
    for (const NamedPart& part : list_parts(slot)) {
        names.push_back(part.name);
    }
    return names;
}

void add_trace_options(Options& options, TraceOptions& tracing) {
    options.choice("--structure", tracing.structure, "what the rays walk through",
                   structure_names());
    add_walk_options(options, tracing);
}

void add_walk_options(Options& options, TraceOptions& tracing) {
    options.choice("--triangle", tracing.triangle, "the triangle test", part_names("triangle"));
    options.input_file("--rays", tracing.rays,
                       "trace the rays of this file (.f32 or .csv) instead of a picture's");
    options.output_file("--hits", tracing.hits, "the file for the hits of --rays (.f32 or .csv)");
    options.check([&] {
        if (tracing.rays.empty() != tracing.hits.empty()) {
            throw InputError("--rays and --hits go together: name a file of rays and a file for "
                             "their hits.");
        }
    });
    add_build_options(options, tracing.build_values);
}

void add_build_options(Options& options, std::map<std::string, std::string>& values) {
    for (const auto& [name, option] : all_build_options()) {
        options.value("--" + name, "", option.meaning,
                      [&values, key = name](const std::string& value) { values[key] = value; });
    }
}

std::vector<std::string> view_names() {
    std::vector<std::string> views = part_names("view");
    views.insert(views.end(), {"visits", "tests"});
    return views;
}

void refuse_empty_heat_map(const std::string& view, const TraceOptions& tracing) {
    if (view == "visits" && tracing.structure == "every_triangle") {
        throw InputError("--view visits: the loop over every triangle visits no cells. Take "
                         "--view tests, or another --structure.");
    }
}

void add_view_option(Options& options, std::string& view, const TraceOptions& tracing) {
    options.choice("--view", view, "what to show of the hits, or a heat map of the work",
                   view_names());
    options.check([&] {
        if (options.given("--view")) {
            refuse_empty_heat_map(view, tracing);
        } else if (view == "visits" && tracing.structure == "every_triangle") {
            view = "tests";
        }
    });
}

BuiltStructure build_structure(const std::string& structure, std::span<const glm::vec3> corners,
                               BuildRequest request,
                               const std::map<std::string, Builder>& own_builders) {
    const StructureFamily family = family_of(structure);
    check_build_values(request.values, {{structure}});
    request.say = print_memory;
    request.most_texels = most_buffer_texels();
    // What a chapter builds by itself it does not read from files.
    const auto own =
        request.values.contains("tree") ? own_builders.end() : own_builders.find(family.name);
    BuiltStructure built;
    {
        const WorkNotice notice("building " + structure);
        built = (own != own_builders.end() ? own->second : family.build)(corners, request);
    }
    print_facts(structure, built.facts);
    return built;
}

float camera_reach(const PictureOptions& picture, const Scene& scene) {
    Box origins = origins_of(scene.camera);
    if (picture.window) {
        const glm::vec3 room(room_to_move(scene.camera));
        // The box of every lens around an eye in the room; a step further, for the rounded sums.
        origins.lower -= 1.0001f * room;
        origins.upper += 1.0001f * room;
    }
    return reach_of(origins, scene.corners);
}

} // namespace raysteps
