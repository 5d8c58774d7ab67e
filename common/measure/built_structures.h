#pragma once

#include "render/scene_textures.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <map>
#include <string>
#include <vector>

namespace raysteps {

// The choices without options of their own.
std::vector<StructureChoice> plain_structures(const std::vector<std::string>& names);

// The options with which each choice is built, by the name that it has in tables: its own, else the
// values for all that its builder knows, else the initial ones.
std::map<std::string, std::map<std::string, std::string>>
used_builders(const std::vector<StructureChoice>& choices,
              const std::map<std::string, std::string>& values);

// A scene with structures that were built in it; choices of one family and the same options share
// one.
class BuiltStructures {
public:
    // A builder takes those of the values that it knows.
    BuiltStructures(const Scene& scene, const std::vector<StructureChoice>& choices,
                    std::map<std::string, std::string> values);

    const SceneTextures& of(const StructureChoice& choice) const;

private:
    std::map<std::string, std::string> values_;
    std::map<std::string, SceneTextures> built_;
};

} // namespace raysteps
