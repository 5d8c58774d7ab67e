#include "structure/bvh/bvh.h"
#include "structure/bvh/family_bvh.h"
#include "structure/tree_file/tree_file.h"

namespace raysteps {

// Serves structure/bvh/half_bvh.glsl: the tree of the family `bvh`, with its options, in fewer
// bits.
StructureFamily family_half_bvh() {
    StructureFamily whole = family_bvh();
    // Halves round the boxes outwards: a file's tree would be another one.
    std::erase_if(whole.options,
                  [](const BuildOption& option) { return option.name == tree_option.name; });
    return {"half_bvh", whole.options,
            [build = whole.build](std::span<const glm::vec3> corners, const BuildRequest& request) {
                BuiltStructure built = build(corners, request);
                built.packed = with_half_boxes(built.packed);
                for (Fact& fact : built.facts) {
                    if (fact.name == "memory_bytes") {
                        fact.value = static_cast<double>(bytes_of(built.packed));
                    }
                }
                return built;
            }};
}

} // namespace raysteps
