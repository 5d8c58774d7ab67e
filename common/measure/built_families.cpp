#include "measure/built_families.h"

#include "structure/families.h"
#include "structure/reach.h"

namespace raysteps {

namespace {

std::map<std::string, std::string> own_values(const StructureFamily& family,
                                              const std::map<std::string, std::string>& values) {
    std::map<std::string, std::string> own;
    for (const BuildOption& option : family.options) {
        const auto value = values.find(option.name);
        if (value != values.end()) {
            own.insert(*value);
        }
    }
    return own;
}

} // namespace

BuiltFamilies build_families(const Scene& scene, const std::vector<std::string>& structures,
                             const std::map<std::string, std::string>& values) {
    const float reach = reach_of(scene.camera.eye, scene.corners);
    BuiltFamilies built;
    for (const std::string& structure : structures) {
        const StructureFamily family = family_of(structure);
        if (built.contains(family.name)) {
            continue;
        }
        const BuildRequest request{.reach = reach, .values = own_values(family, values)};
        built.emplace(family.name, upload(scene, family.build(scene.corners, request)));
    }
    return built;
}

const SceneTextures& built_for(const BuiltFamilies& built, const std::string& structure) {
    return built.at(family_of(structure).name);
}

} // namespace raysteps
