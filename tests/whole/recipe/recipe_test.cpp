#include "catch.h"
#include "gpu/shaders.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "mirror/trace_by_mirror.h"
#include "structure/padding.h"
#include "support/compare_hits.h"
#include "support/gpu_hits.h"
#include "visualizer/replay/sentence.h"
#include "visualizer/replay/shader_line.h"
#include "visualizer/replay/walk_recorder.h"

#include <algorithm>

using namespace raysteps;

// The walk RECIPE_WALK is the file that the recipe of docs/book/add_a_structure.md makes, and
// nothing else was changed.

namespace {

const std::string walk_name = RECIPE_WALK;

bool names(const std::vector<std::string>& all, const std::string& name) {
    return std::find(all.begin(), all.end(), name) != all.end();
}

} // namespace

TEST_CASE("a copied walk is in the catalogue, the mirror and the replay", "[recipe]") {
    CHECK_NOTHROW(find_part("structure", walk_name));
    CHECK(mirror_walks().count(walk_name) == 1);
    CHECK(names(recorded_structures(), walk_name));
    CHECK(family_of(walk_name).name == family_of(RECIPE_COPIED).name);
}

TEST_CASE("a copied walk finds the bits of the loop on the GPU, as C++ and in the replay",
          "[recipe]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 2000);
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> expected = mirror_triangle_tests().at("watertight")(buffers, {}, rays);
    CHECK(count_hits(expected) > 1000);
    const BuiltStructure built =
        family_of(walk_name).build(scene.corners, {reach_of(rays, scene.corners), {}});
    CHECK(count_different(mirror_walks().at(walk_name)(buffers, built.packed, rays), expected) ==
          0);
    const auto context = make_context(ContextKind::automatic);
    CHECK(count_different(gpu_hits_of(scene, rays, walk_name), expected) == 0);

    const WalkRecorder recorder = make_recorder(walk_name, {buffers, built.packed});
    const StructureCells cells = cells_of(built.packed, {});
    std::size_t different = 0;
    for (std::size_t i = 0; i < 100; ++i) {
        const RecordedWalk walk = recorder.record(rays[i], Question::nearest);
        different += count_different(std::vector<Hit>{walk.hit}, std::vector<Hit>{expected[i]});
        for (std::size_t step = 0; step < walk.steps.size(); ++step) {
            CHECK_FALSE(sentence_of(cells, walk, step).empty());
            CHECK(deciding_line(walk, step).number > 0);
        }
    }
    CHECK(different == 0);
}
