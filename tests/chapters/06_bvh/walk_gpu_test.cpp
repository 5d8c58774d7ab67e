#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"
#include "support/compare_hits.h"
#include "support/gpu_hits.h"

using namespace raysteps;

TEST_CASE("no triangle and one are answered by every BVH walk on the GPU", "[06][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene one = scene_of(triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}));
    const std::vector<Ray> rays{{{0, 0, -1}, {0, 0, 1}, 0.0f, no_end},
                                {{5, 0, -1}, {0, 0, 1}, 0.0f, no_end}};
    for (const std::string walk :
         {"bvh_skip", "bvh_skip_padded", "bvh_ordered", "bvh_parent", "bvh_stack", "bvh4"}) {
        CAPTURE(walk);
        const std::vector<Hit> hits = gpu_hits_of(one, rays, walk);
        CHECK(hits[0].triangle == 0);
        CHECK(hits[0].t == 1.0f);
        CHECK(hits[1].triangle == no_triangle);
        CHECK(count_hits(gpu_hits_of(Scene{}, rays, walk)) == 0);
    }
}
