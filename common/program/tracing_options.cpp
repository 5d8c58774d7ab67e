#include "program/tracing_options.h"

#include "program/progress.h"
#include "basics/error.h"
#include "gpu/shaders.h"
#include "structure/structure.h"
#include "structure/padding.h"

#include <cstdio>

namespace raysteps {

namespace {

// In a window a person moves the camera: so many times as far as it starts.
constexpr float room_to_move = 16.0f;

std::string join_names(const std::vector<NamedPart>& parts) {
    std::string names;
    for (const NamedPart& part : parts) {
        names += (names.empty() ? "" : ", ") + part.name;
    }
    return names;
}

BuiltStructure build(const Command& command, const Scene& scene, float reach) {
    const StructureFamily family = family_of(command.structure);
    check_build_values(command, {{command.structure}});
    BuiltStructure built;
    {
        const WorkNotice notice("building " + command.structure);
        built = family.build(
            scene.corners,
            {.reach = reach, .values = command.build_values, .say = [](const std::string& what) {
                 std::printf("memory    %s\n", what.c_str());
                 std::fflush(stdout);
             }});
    }
    if (!built.facts.empty()) {
        std::printf("structure %s:", command.structure.c_str());
        for (std::size_t i = 0; i < built.facts.size(); ++i) {
            std::printf("%s %s %.6g", i == 0 ? "" : ",", built.facts[i].name.c_str(),
                        built.facts[i].value);
        }
        std::printf("\n");
        std::fflush(stdout);
    }
    return built;
}

} // namespace

void add_tracing_options(CLI::App& app, Command& command) {
    app.add_option("--triangle", command.triangle,
                   "the triangle test: " + join_names(list_parts("triangle")))
        ->capture_default_str();
    app.add_option("--structure", command.structure,
                   "what the rays walk through: " + join_names(list_parts("structure")))
        ->capture_default_str();
    app.add_option("--rays", command.rays,
                   "trace the rays of this file (.f32 or .csv) instead of a picture's");
    app.add_option("--hits", command.hits, "the file for the hits of --rays (.f32 or .csv)");
    for (const auto& [name, option] : all_build_options()) {
        app.add_option_function<std::string>(
            "--" + name,
            [&command, key = name](const std::string& value) { command.build_values[key] = value; },
            option.meaning);
    }
}

void check_build_values(const Command& command, std::span<const std::string> structures) {
    check_build_values(command.build_values, structures);
}

Parts trace_parts(const Command& command) {
    return {{"triangle", find_part("triangle", command.triangle)},
            {"structure", find_part("structure", command.structure)}};
}

BuiltStructure build_structure(const Command& command, const Scene& scene) {
    const float reach = reach_of(scene.camera.eye, scene.corners);
    return build(command, scene, command.window ? room_to_move * reach : reach);
}

BuiltStructure build_structure(const Command& command, const Scene& scene,
                               std::span<const Ray> rays) {
    return build(command, scene, reach_of(rays, scene.corners));
}

} // namespace raysteps
