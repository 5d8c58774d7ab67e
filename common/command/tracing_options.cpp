#include "command/tracing_options.h"

#include "command/progress.h"
#include "error/error.h"
#include "gpu/shader_catalog.h"
#include "structure/families.h"
#include "structure/reach.h"

#include <cstdio>
#include <set>

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

// Several builders may ask for an option of the same name; each explains its own values.
std::map<std::string, BuildOption> merged_options() {
    std::map<std::string, BuildOption> merged;
    for (const StructureFamily& family : list_families()) {
        for (const BuildOption& option : family.options) {
            auto [place, is_new] = merged.try_emplace(option.name, option);
            std::string& meaning = place->second.meaning;
            const std::string own =
                family.name + ": " + option.meaning + " (" + option.initial + ")";
            meaning = is_new ? own : meaning + "; " + own;
        }
    }
    return merged;
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
    for (const auto& [name, option] : merged_options()) {
        app.add_option_function<std::string>(
            "--" + name,
            [&command, key = name](const std::string& value) { command.build_values[key] = value; },
            option.meaning);
    }
}

void check_build_values(const Command& command, std::span<const std::string> structures) {
    std::string names;
    std::string options;
    std::set<std::string> known;
    for (const std::string& structure : structures) {
        names += (names.empty() ? "" : ", ") + structure;
        for (const BuildOption& option : family_of(structure).options) {
            if (known.insert(option.name).second) {
                options += (options.empty() ? "--" : ", --") + option.name;
            }
        }
    }
    for (const auto& [name, value] : command.build_values) {
        if (!known.contains(name)) {
            throw InputError("--" + name + " " + value + ": not an option of " + names +
                             (options.empty() ? ", which has none. Leave it out, or choose another "
                                                "--structure."
                                              : ". Take one of " + options + "."));
        }
    }
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
