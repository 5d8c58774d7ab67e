#include "catch.h"
#include "gpu/shaders.h"
#include "replayed.h"
#include "support/same_bits.h"

#include <algorithm>

using namespace raysteps;

namespace {

Scene sphere_with_triangles(int seed) {
    RandomNumbers numbers(seed);
    return scene_of(join(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3), random_triangles(numbers, 150)));
}

WalkCount counts_in(const RecordedWalk& walk) {
    WalkCount count;
    for (const Step& step : walk.steps) {
        count.visits += step.outcome == Outcome::tested ? 0 : 1;
    }
    count.tests = static_cast<std::uint32_t>(walk.tests.size());
    return count;
}

} // namespace

TEST_CASE("the walks of every structure can be recorded", "[replay][walks]") {
    std::vector<std::string> names;
    for (const NamedPart& part : list_parts("structure")) {
        names.push_back(part.name);
    }
    CHECK(recorded_structures() == names);
    const mirror::SceneBuffers none(Scene{});
    const PackedStructure nothing;
    CHECK_THROWS_WITH(make_recorder("gird", {none, nothing}),
                      contains_text("gird") && contains_text("grid_mailbox"));
}

TEST_CASE("a recorded walk is what the GPU counts and finds for the same ray", "[replay][gpu]") {
    const int seed = 81;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = sphere_with_triangles(seed);
    std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 300);
    for (const Ray& ray : random_rays(numbers, 200)) {
        rays.push_back(ray);
    }
    for (const Ray& ray : axis_parallel_rays(numbers, scene.corners, 100)) {
        rays.push_back(ray);
    }
    const auto context = make_context(ContextKind::automatic);
    const RayTextures textures = upload_rays(rays);
    for (const std::string& structure : recorded_structures()) {
        CAPTURE(structure);
        const Replayed replayed(scene, structure, reach_of(rays, scene.corners));
        TraceRays trace({{"triangle", "triangle/watertight.glsl"},
                         {"structure", find_part("structure", structure)},
                         {"observer", "observer/count.glsl"}},
                        2048);
        const SceneTextures on_gpu = upload(scene, replayed.built);
        const std::vector<Hit> hits = read_hits(trace.closest_hits(textures, on_gpu), rays.size());
        const std::vector<glm::uvec4> counted = read_list(*trace.observations(), rays.size());
        const std::vector<WalkCount> counts = replayed.recorder.count(rays);
        std::size_t different_hits = 0;
        std::size_t different_counts = 0;
        std::size_t different_quick_counts = 0;
        std::uint32_t visits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const RecordedWalk walk = replayed.recorder.record(rays[i], Question::nearest);
            const WalkCount count = counts_in(walk);
            different_hits += same_bits(walk.hit, hits[i]) ? 0 : 1;
            different_counts += count.visits == counted[i].x && count.tests == counted[i].y ? 0 : 1;
            different_quick_counts +=
                count.visits == counts[i].visits && count.tests == counts[i].tests ? 0 : 1;
            visits += count.visits + count.tests;
        }
        CHECK(different_hits == 0);
        CHECK(different_counts == 0);
        CHECK(different_quick_counts == 0);
        CHECK(visits > 5 * rays.size());
    }
}

TEST_CASE("the steps of a walk explain its hit and where it goes", "[replay][walks]") {
    const int seed = 82;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = sphere_with_triangles(seed);
    std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 200);
    for (const auto& more :
         {random_rays(numbers, 200), axis_parallel_rays(numbers, scene.corners, 100),
          segments(numbers, scene.corners, 100)}) {
        rays.insert(rays.end(), more.begin(), more.end());
    }
    for (const std::string& structure : recorded_structures()) {
        CAPTURE(structure);
        const Replayed replayed(scene, structure, reach_of(rays, scene.corners));
        for (const Question question : {Question::nearest, Question::any}) {
            std::size_t wrong_hits = 0;
            std::size_t wrong_ways = 0;
            std::size_t wrong_endings = 0;
            for (const Ray& ray : rays) {
                const RecordedWalk walk = replayed.recorder.record(ray, question);
                const bool has_hit = walk.hit.triangle != no_triangle;
                if (!walk.steps.empty()) {
                    wrong_hits += same_bits(walk.steps.back().nearest, walk.hit) ? 0 : 1;
                }
                const bool hit_ending = walk.ending == Ending::hit || walk.ending == Ending::found;
                wrong_endings += hit_ending && !has_hit ? 1 : 0;
                wrong_endings += walk.ending == Ending::no_way_in && has_hit ? 1 : 0;
                for (std::size_t i = 0; i + 1 < walk.steps.size(); ++i) {
                    const Step& step = walk.steps[i];
                    const Step& next = walk.steps[i + 1];
                    if (step.cell == no_cell) {
                        continue;
                    }
                    const Cell& next_cell =
                        replayed.cells.cells[static_cast<std::size_t>(next.cell)];
                    const Cell& cell = replayed.cells.cells[static_cast<std::size_t>(step.cell)];
                    // From an inner node that is met, always to a child.
                    if (step.outcome == Outcome::entered) {
                        wrong_ways += next_cell.parent == step.cell ? 0 : 1;
                    }
                    // A kd-tree's child is the one that holds the ray at t.
                    if (step.outcome == Outcome::entered &&
                        replayed.cells.kind == CellKind::kd_tree &&
                        ray.direction[step.axis] != 0.0f) {
                        const bool upper = next_cell.box.lower[cell.axis] == cell.split;
                        const bool passed = step.plane_t <= step.entry;
                        wrong_ways +=
                            upper == (passed == (ray.direction[step.axis] > 0.0f)) ? 0 : 1;
                    }
                    // A grid's next cell is the neighbour, and begins where this one ends.
                    if (replayed.cells.kind == CellKind::grid) {
                        const float plane = step.face % 2 == 0 ? cell.box.lower[step.axis]
                                                               : cell.box.upper[step.axis];
                        const float entered = step.face % 2 == 0 ? next_cell.box.upper[step.axis]
                                                                 : next_cell.box.lower[step.axis];
                        wrong_ways += plane == entered && next.entry == step.exit ? 0 : 1;
                    }
                }
            }
            CHECK(wrong_hits == 0);
            CHECK(wrong_ways == 0);
            CHECK(wrong_endings == 0);
        }
    }
}

TEST_CASE("a box that a BVH walk enters holds the ray as long as the step says",
          "[replay][walks]") {
    const int seed = 83;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = sphere_with_triangles(seed);
    const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 200);
    for (const std::string structure :
         {"bvh_skip", "bvh_ordered", "bvh_parent", "bvh_stack", "bvh4"}) {
        CAPTURE(structure);
        const Replayed replayed(scene, structure, reach_of(rays, scene.corners));
        std::size_t entered = 0;
        std::size_t outside = 0;
        std::size_t met_though_missed = 0;
        for (const Ray& ray : rays) {
            for (const Step& step : replayed.recorder.record(ray, Question::nearest).steps) {
                const Box& box = replayed.cells.cells[static_cast<std::size_t>(step.cell)].box;
                met_though_missed += step.outcome == Outcome::missed && step.entry <= step.exit;
                if (step.outcome == Outcome::missed) {
                    continue;
                }
                ++entered;
                for (const float t : {step.entry, step.exit}) {
                    const glm::dvec3 point =
                        glm::dvec3(ray.origin) + static_cast<double>(t) * glm::dvec3(ray.direction);
                    for (int axis = 0; axis < 3; ++axis) {
                        // A plane's t is rounded three times (structure/bvh/box_ray.glsl): 3 e M,
                        // and M is under 8 here.
                        const double room = 3.0 * 0x1p-24 * 8.0;
                        outside += point[axis] < static_cast<double>(box.lower[axis]) - room ||
                                   point[axis] > static_cast<double>(box.upper[axis]) + room;
                    }
                }
            }
        }
        CHECK(entered > 1000);
        CHECK(outside == 0);
        CHECK(met_though_missed == 0);
    }
}

TEST_CASE("a ray that passes everything by and an empty scene have no step", "[replay][walks]") {
    const Ray aside{{5.0f, 5.0f, 5.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end};
    for (const std::string& structure : recorded_structures()) {
        CAPTURE(structure);
        const Replayed empty(Scene{}, structure, 0.0f);
        CHECK(empty.recorder.record(along_z, Question::nearest).tests.empty());
        const Replayed replayed(two_triangles(), structure, 10.0f);
        const RecordedWalk walk = replayed.recorder.record(aside, Question::nearest);
        CHECK(walk.hit.triangle == no_triangle);
        if (replayed.cells.kind == CellKind::grid || replayed.cells.kind == CellKind::kd_tree) {
            CHECK(walk.steps.empty());
            CHECK(walk.ending == Ending::no_way_in);
        }
    }
}
