#pragma once

#include "scene/scene.h"
#include "structure/structure.h"

#include <span>
#include <string>

namespace raysteps {

// A scene with structures over it as the page of the playground (docs/playground) reads them: four
// bytes with the length of the JSON head, the head, and the arrays that it names, one behind the
// other. Everything goes under the name of its uniform, so a new structure needs nothing here. The
// camera's view is for pictures of this aspect ratio.
std::string playground_file(const Scene& scene, double aspect_ratio,
                            std::span<const StructureFamily> families, const BuildRequest& request);

} // namespace raysteps
