#include "steps.h"

#include "structure/structure.h"

namespace raysteps {

std::vector<SpeedStep> speed_steps() {
    return {{.name = "skip, in rows", .structure = "bvh_skip", .layout = ListLayout::rows},
            {.name = "skip, in blocks", .structure = "bvh_skip"},
            {.name = "ordered", .structure = "bvh_ordered"},
            {.name = "four boxes", .structure = "bvh4"},
            {.name = "four rays", .structure = "packet_bvh4"}};
}

bool takes(const RayKind& kind, const SpeedStep& step) {
    return kind.coherence == Coherence::neighbours || !has_packets(step.structure);
}

} // namespace raysteps
