#include "structure/structure.h"

namespace raysteps {

// No structure: nothing is built, and each ray tests every triangle.
StructureFamily family_every_triangle() {
    return {"every_triangle", {}, [](std::span<const glm::vec3> corners, const BuildRequest&) {
                BuiltStructure built;
                const int triangles = static_cast<int>(corners.size() / 3);
                built.packed.numbers["triangle_count"] = triangles;
                built.longest_walk = triangles;
                return built;
            }};
}

} // namespace raysteps
