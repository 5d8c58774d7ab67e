#include "catch.h"
#include "replayed.h"
#include "visualizer/replay/parting.h"

using namespace raysteps;

namespace {

Scene loose_triangles(int seed) {
    RandomNumbers numbers(seed);
    return scene_of(random_triangles(numbers, 300));
}

} // namespace

TEST_CASE("a walk never parts from itself", "[replay][parting]") {
    RandomNumbers numbers(91);
    const Scene scene = loose_triangles(91);
    const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 20);
    for (const std::string& structure : recorded_structures()) {
        const Replayed replayed(scene, structure, 10.0f);
        for (const Ray& ray : rays) {
            const RecordedWalk walk = replayed.recorder.record(ray, Question::nearest);
            CHECK(!find_parting({replayed.cells, walk}, {replayed.cells, walk}));
        }
    }
}

TEST_CASE("a restart and a backtrack part where one begins at the root again",
          "[replay][parting]") {
    RandomNumbers numbers(92);
    const Scene scene = loose_triangles(92);
    const Replayed restart(scene, "kd_restart", 10.0f);
    const Replayed backtrack(scene, "kd_backtrack", 10.0f);
    int parted = 0;
    for (const Ray& ray : rays_at_triangles(numbers, scene.corners, 100)) {
        const RecordedWalk a = restart.recorder.record(ray, Question::nearest);
        const RecordedWalk b = backtrack.recorder.record(ray, Question::nearest);
        const auto parting = find_parting({restart.cells, a}, {backtrack.cells, b});
        if (!parting || parting->first_step + 1 == a.steps.size() ||
            parting->second_step + 1 == b.steps.size()) {
            continue;
        }
        ++parted;
        REQUIRE(parting->first_step == parting->second_step);
        const std::size_t step = parting->first_step;
        REQUIRE(step > 0);
        // The step before is the same leaf.
        CHECK(a.steps[step - 1].cell == b.steps[step - 1].cell);
        CHECK(a.steps[step - 1].outcome == Outcome::leaf);
        CHECK(a.steps[step].cell == 0);
    }
    CHECK(parted > 20);
}

TEST_CASE("walks in two structures part at the first test that is not the same",
          "[replay][parting]") {
    const Scene scene = two_triangles();
    const Replayed loop(scene, "every_triangle", 0.0f);
    const Replayed tree(scene, "bvh_ordered", 0.0f, {{"leaf-triangles", "1"}});
    const Ray back{{0.0f, 0.0f, 2.0f}, {0.0f, 0.0f, -1.0f}, 0.0f, no_end};
    const RecordedWalk all = loop.recorder.record(back, Question::nearest);
    const RecordedWalk walk = tree.recorder.record(back, Question::nearest);
    const auto parting = find_parting({loop.cells, all}, {tree.cells, walk});
    REQUIRE(parting);
    CHECK(parting->first_step == 0);  // tests triangle 0
    CHECK(parting->second_step == 1); // the leaf that tests triangle 1

    // Along z the tree tests triangle 0 and then nothing.
    const RecordedWalk first = loop.recorder.record(along_z, Question::nearest);
    const RecordedWalk second = tree.recorder.record(along_z, Question::nearest);
    const auto later = find_parting({loop.cells, first}, {tree.cells, second});
    REQUIRE(later);
    CHECK(later->first_step == 1);
    CHECK(later->second_step == second.steps.size() - 1);
}
