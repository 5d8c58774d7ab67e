#include "07_compare/builds.h"

#include "basics/error.h"
#include "catch.h"
#include "hard_cases/meshes.h"
#include "reference/embree/embree.h"
#include "scene/load_scene.h"

using namespace raysteps;

namespace {

const Progress quiet = [](double) {};

} // namespace

TEST_CASE("the table of builds has the middle and the range and their ratio", "[07][builds]") {
    const BuildContest contest{"ball", 1000, {200.0, 100.0, 300.0}, {400.0, 300.0, 500.0}, 1.004};
    CHECK(to_csv({contest}) == "scene,triangles,nanoseconds_per_triangle,"
                               "embree_nanoseconds_per_triangle,ratio,cost_to_sweep\n"
                               "ball,1000,200,400,0.5,1.004\n");
    CHECK_THAT(to_table({contest}), contains_text("200 (100-300)") &&
                                        contains_text("400 (300-500)") && contains_text(" 0.50 "));
}

TEST_CASE("Embree's tree holds every triangle in leaves no larger than asked", "[07][builds]") {
    RandomNumbers numbers(3);
    const std::vector<glm::vec3> corners = random_triangles(numbers, 500).corners;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        boxes.push_back(bounds_of(std::span(corners).subspan(i, 3)));
    }
    EmbreeBuilder builder(boxes, {.leaf_triangles = 4});
    for (int time = 0; time < 2; ++time) {
        builder.prepare();
        const EmbreeTree tree = builder.build();
        CHECK(tree.triangles == 500);
        CHECK(tree.leaves >= 125);
        CHECK(tree.inner_nodes == tree.leaves - 1); // as in every binary tree
    }
}

TEST_CASE("bins cost a ray at most a fiftieth more than a full sweep", "[07][builds]") {
    for (const char* name : {"bunny", "knot:4", "stadium:2", "soup"}) {
        CAPTURE(name);
        const BuildContest contest = contest_builds(load_scene(name, 1.0f), {}, 1, quiet);
        CHECK(contest.triangles > 1000);
        CHECK(contest.ours.lowest > 0.0);
        CHECK(contest.embrees.lowest > 0.0);
        CHECK(contest.cost_to_sweep > 0.98);
        CHECK(contest.cost_to_sweep <= 1.02);
    }
}

TEST_CASE("a scene without a triangle has no builds", "[07][builds]") {
    Scene empty;
    empty.name = "nothing";
    CHECK_THROWS_AS(contest_builds(empty, {}, 1, quiet), InputError);
}

TEST_CASE("two bins cost a ray more than the builder's own 32", "[07][builds]") {
    const Scene scene = load_scene("knot:4", 1.0f);
    const BuildContest two = contest_builds(scene, {.values = {{"bins", "2"}}}, 1, quiet);
    CHECK(two.cost_to_sweep > contest_builds(scene, {}, 1, quiet).cost_to_sweep);
}
