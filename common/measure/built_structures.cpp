#include "measure/built_structures.h"

#include "structure/padding.h"

namespace raysteps {

namespace {

// The values for all that this choice's builder knows, and over them its own.
std::map<std::string, std::string> values_of(const StructureChoice& choice,
                                             const std::map<std::string, std::string>& values) {
    std::map<std::string, std::string> own = choice.values;
    for (const BuildOption& option : family_of(choice.structure).options) {
        const auto value = values.find(option.name);
        if (value != values.end()) {
            own.insert(*value); // unless it is there
        }
    }
    return own;
}

std::string key_of(const StructureChoice& choice,
                   const std::map<std::string, std::string>& values) {
    std::string key = family_of(choice.structure).name;
    for (const auto& [name, value] :
         used_build_values(choice.structure, values_of(choice, values))) {
        key += ":" + name + "=" + value;
    }
    return key;
}

} // namespace

std::vector<StructureChoice> plain_structures(const std::vector<std::string>& names) {
    std::vector<StructureChoice> choices;
    for (const std::string& name : names) {
        choices.push_back({.text = name, .structure = name});
    }
    return choices;
}

std::map<std::string, std::map<std::string, std::string>>
used_builders(const std::vector<StructureChoice>& choices,
              const std::map<std::string, std::string>& values) {
    std::map<std::string, std::map<std::string, std::string>> used;
    for (const StructureChoice& choice : choices) {
        used[choice.text] = used_build_values(choice.structure, values_of(choice, values));
    }
    return used;
}

BuiltStructures::BuiltStructures(const Scene& scene, const std::vector<StructureChoice>& choices,
                                 std::map<std::string, std::string> values)
    : values_(std::move(values)) {
    const float reach = reach_of(scene.camera.eye, scene.corners);
    for (const StructureChoice& choice : choices) {
        const std::string key = key_of(choice, values_);
        if (!built_.contains(key)) {
            const BuildRequest request{.reach = reach, .values = values_of(choice, values_)};
            built_.emplace(
                key, upload(scene, family_of(choice.structure).build(scene.corners, request)));
        }
    }
}

const SceneTextures& BuiltStructures::of(const StructureChoice& choice) const {
    return built_.at(key_of(choice, values_));
}

} // namespace raysteps
