#include "structure/structure.h"

namespace raysteps {

StructureFamily family_every_triangle() {
    return {"every_triangle", {}, [](std::span<const glm::vec3> corners, const BuildRequest&) {
                return every_triangle(static_cast<int>(corners.size() / 3));
            }};
}

} // namespace raysteps
