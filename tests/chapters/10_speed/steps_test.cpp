#include "10_speed/climb.h"

#include "catch.h"
#include "gpu/context.h"
#include "measure/built_structures.h"
#include "scene/load_scene.h"

#include <glm/geometric.hpp>

using namespace raysteps;

TEST_CASE("each step differs from the one before, and the last is for neighbours only", "[10]") {
    const std::vector<SpeedStep> steps = speed_steps();
    REQUIRE(steps.size() == 5);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const bool other_walk = steps[i].structure != steps[i - 1].structure;
        const bool other_layout = steps[i].layout != steps[i - 1].layout;
        CAPTURE(steps[i].name);
        CHECK(other_walk != other_layout); // one idea
    }
    const RayKind neighbours{"primary", Query::closest, {}, Coherence::neighbours};
    const RayKind alone{"bounce", Query::closest, {}, Coherence::alone};
    CHECK(takes(neighbours, steps.back()));
    CHECK_FALSE(takes(alone, steps.back()));
    CHECK(takes(alone, steps.front()));
}

TEST_CASE("a list in rows lies as it was written down", "[10][rays]") {
    const auto context = make_context(ContextKind::automatic);
    std::vector<Ray> rays(3000);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin.x = static_cast<float>(i);
        rays[i].direction.z = 1.0f;
    }
    const std::vector<Ray> texels = read_rays(upload_rays(rays, ListLayout::rows));
    REQUIRE(texels.size() >= rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        REQUIRE(texels[i].origin.x == rays[i].origin.x);
    }
    for (std::size_t i = rays.size(); i < texels.size(); ++i) {
        REQUIRE(texels[i].t_max < texels[i].t_min);
    }
}

TEST_CASE("rays know the primary ray that they come from", "[10][rays]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene("compact:4", 1.0f);
    const BuiltStructures built(scene, plain_structures({"bvh4"}), {});
    TraceRays trace(walk_parts("watertight", "bvh4"), measure_limits());
    const RayTextures camera = generate_rays(scene.camera, 24, 24, RayGeneration::direct);
    const std::vector<Ray> primary = read_rays(camera);
    const std::vector<Hit> hits = read_hits(trace.closest_hits(camera, built.of({"bvh4", "bvh4"})));
    const std::vector<RayKind> kinds = ray_kinds(scene, primary, hits, 1);
    REQUIRE(kinds.size() == 4);
    for (const RayKind& kind : kinds) {
        CAPTURE(kind.name);
        REQUIRE(kind.from.size() == kind.rays.size());
        for (std::size_t i = 0; i < kind.rays.size(); ++i) {
            const Ray& from = primary[kind.from[i]];
            const glm::vec3 start = kind.name == "primary"
                                        ? from.origin
                                        : from.origin + hits[kind.from[i]].t * from.direction;
            REQUIRE(glm::distance(kind.rays[i].origin, start) < 1e-3f);
        }
    }
}

TEST_CASE("speeds are compared round by round", "[10][measure]") {
    // The second round was slow for both.
    const ContestTimes ours{"ours", {{.clock = 9, .cpu = 1}, {.clock = 9, .cpu = 8}}};
    const ContestTimes theirs{"theirs", {{.clock = 9, .cpu = 2}, {.clock = 9, .cpu = 16}}};
    const MeasuredRange ratio = speed_ratio(ours, 3.0, theirs, 1.0, &Seconds::cpu);
    CHECK(ratio.lowest == 6.0);
    CHECK(ratio.highest == 6.0);
    CHECK(speed_ratio(ours, 1.0, theirs, 1.0, &Seconds::clock).median == 1.0);
}
