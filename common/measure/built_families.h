#pragma once

#include "render/scene_textures.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <vector>

namespace raysteps {

// A scene with a built structure of each family, by the family's name.
using BuiltFamilies = std::map<std::string, SceneTextures>;

// Builds each family of these structures once, for all its walks. The values are those of --NAME; a
// builder is given those that it knows. A context must be current. Throws InputError as the
// builders do.
BuiltFamilies build_families(const Scene& scene, const std::vector<std::string>& structures,
                             const std::map<std::string, std::string>& values);

// The one that serves the structure of that name, which must be among those that were built.
const SceneTextures& built_for(const BuiltFamilies& built, const std::string& structure);

} // namespace raysteps
