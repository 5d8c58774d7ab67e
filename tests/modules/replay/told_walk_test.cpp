#include "basics/error.h"
#include "catch.h"
#include "replayed.h"
#include "visualizer/replay/parting.h"
#include "visualizer/replay/told_walk.h"

using namespace raysteps;

namespace {

// What a walk of ours would tell of itself.
ToldWalk told_by(const RecordedWalk& walk) {
    ToldWalk told{"told", "", walk.structure, walk.ray, walk.question, {}, true, walk.hit};
    for (const Step& step : walk.steps) {
        ToldStep said{step.place, 0, {}, step.nearest, {}, {}};
        for (const TriangleTest& test : tests_of(walk, step)) {
            said.tested.push_back(test.triangle);
        }
        told.steps.push_back(said);
    }
    return told;
}

} // namespace

TEST_CASE("a told walk means what the walk that tells it means", "[replay][told]") {
    RandomNumbers numbers(93);
    const Scene scene = scene_of(random_triangles(numbers, 300));
    const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 20);
    for (const std::string& structure : recorded_structures()) {
        CAPTURE(structure);
        const Replayed replayed(scene, structure, 10.0f);
        for (const Ray& ray : rays) {
            const RecordedWalk walk = replayed.recorder.record(ray, Question::nearest);
            const RecordedWalk again = replayed.recorder.explain(told_by(walk));
            REQUIRE(again.steps.size() == walk.steps.size());
            for (std::size_t i = 0; i < walk.steps.size(); ++i) {
                CHECK(again.steps[i].cell == walk.steps[i].cell);
                CHECK(again.steps[i].outcome == walk.steps[i].outcome);
                CHECK(again.steps[i].exit == walk.steps[i].exit);
            }
            CHECK(!find_parting({replayed.cells, walk}, {replayed.cells, again}));
        }
    }
}

TEST_CASE("a told walk parts where it tells of another hit, place or test", "[replay][told]") {
    RandomNumbers numbers(94);
    const Scene scene = scene_of(random_triangles(numbers, 300));
    const Replayed grid(scene, "grid", 10.0f);
    for (const Ray& ray : rays_at_triangles(numbers, scene.corners, 20)) {
        const RecordedWalk walk = grid.recorder.record(ray, Question::nearest);
        REQUIRE(!walk.steps.empty());
        const std::size_t middle = walk.steps.size() / 2;
        const auto parting_with = [&](const ToldWalk& told) {
            const auto parting =
                find_parting({grid.cells, grid.recorder.explain(told)}, {grid.cells, walk});
            REQUIRE(parting);
            return parting->first_step;
        };
        ToldWalk hit = told_by(walk);
        hit.steps[middle].nearest.triangle += 1;
        CHECK(parting_with(hit) == middle);
        ToldWalk place = told_by(walk);
        place.steps[middle].place = 1 << 20; // which the grid does not have
        CHECK(parting_with(place) == middle);
        ToldWalk test = told_by(walk);
        test.steps[middle].tested.push_back(0);
        CHECK(parting_with(test) == middle);
        ToldWalk shorter = told_by(walk);
        shorter.steps.resize(middle);
        if (middle > 0) {
            CHECK(parting_with(shorter) == middle - 1); // its last step
        }
    }
}

TEST_CASE("a node of a hierarchy is known without its parents", "[replay][told]") {
    RandomNumbers numbers(95);
    const Scene scene = scene_of(random_triangles(numbers, 300));
    const Replayed tree(scene, "bvh_skip", 10.0f);
    for (const Ray& ray : rays_at_triangles(numbers, scene.corners, 20)) {
        const RecordedWalk walk = tree.recorder.record(ray, Question::nearest);
        REQUIRE(walk.steps.size() > 1);
        ToldWalk told = told_by(walk);
        told.steps = {told.steps.back()};
        CHECK(tree.recorder.explain(told).steps.front().cell == walk.steps.back().cell);
    }
}

TEST_CASE("another program's walk brings its own boxes", "[replay][told]") {
    const Scene scene = two_triangles();
    const Replayed loop(scene, "every_triangle", 0.0f);
    const Hit none{no_end, 0.0f, 0.0f, no_triangle};
    const Hit first{1.0f, 0.25f, 0.5f, 0};
    ToldWalk told{"engine", "", "octree", along_z, Question::nearest, {}, true, first};
    told.steps = {{7, 0, {}, none, {}, Box{{-1, -1, 0}, {1, 1, 1}}},
                  {9, 0, {0}, first, {}, Box{{-1, -1, 0}, {1, 1, 0.5f}}}};
    CHECK(!is_walk_of_ours(told));
    const StructureCells cells = told_cells(told);
    REQUIRE(cells.cells.size() == 2);
    const RecordedWalk walk = walk_in_told_cells(told, loop.recorder.explain(told));
    CHECK(walk.steps[0].outcome == Outcome::entered);
    CHECK(walk.steps[1].outcome == Outcome::leaf);
    CHECK(walk.steps[1].cell == 1);
    CHECK(walk.steps[1].entry == 1.0f);
    CHECK(walk.steps[1].exit == 1.5f);
    CHECK(walk.hit.triangle == 0);
}

TEST_CASE("a told test of a triangle that is not in the scene is an error", "[replay][told]") {
    const Replayed loop(two_triangles(), "every_triangle", 0.0f);
    ToldWalk told{"told", "", "every_triangle", along_z, Question::nearest, {}, true, {}};
    told.steps = {{2, 0, {2}, {}, {}, {}}};
    CHECK_THROWS_AS(loop.recorder.explain(told), InputError);
}
