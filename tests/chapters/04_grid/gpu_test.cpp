#include "catch.h"
#include "grid_hits.h"
#include "support/error_of.h"
#include "support/nonsense_answers.h"

#include <algorithm>

using namespace raysteps;

TEST_CASE("the GPU and the mirror walk a grid to the same bits", "[04][gpu]") {
    const int seed = 2;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 500));
    const std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 10000);
    const mirror::SceneBuffers buffers(scene);
    const Grid grid = grid_for(scene, rays, with_resolution(20));
    const PackedStructure packed = pack(grid);
    const std::vector<Hit> expected = hits_by(mirror::mirror_of<GridWalk>(buffers, packed), rays);
    const auto context = make_context(ContextKind::automatic);
    CHECK(count_different(gpu_hits_of(scene, rays, "grid", {{"resolution", "20"}}), expected) == 0);
    CHECK(count_different(gpu_hits_of(scene, rays, "grid_mailbox", {{"resolution", "20"}}),
                          expected) == 0);
}

TEST_CASE("launches of few rounds walk a grid to the same bits", "[04][gpu][launches]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 2000);
    const auto context = make_context(ContextKind::automatic);
    const std::vector<Hit> expected = gpu_hits(scene, rays, "watertight");
    for (const int rounds : {1, 2, 7, 64}) {
        CAPTURE(rounds);
        CHECK(count_different(gpu_hits_of(scene, rays, "grid", {}, rounds), expected) == 0);
        CHECK(count_different(gpu_hits_of(scene, rays, "grid_mailbox", {}, rounds), expected) == 0);
    }
}

TEST_CASE("the GPU answers rays that are no rays", "[04][gpu][hard_case]") {
    const int seed = 4;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 100));
    const std::vector<Ray> rays = nonsense_rays();
    const auto context = make_context(ContextKind::automatic);
    const BuiltStructure built = family_of("grid").build(scene.corners, {});
    const SceneTextures textures = upload(scene, built);
    for (const std::string structure : {"grid", "grid_mailbox"}) {
        CAPTURE(structure);
        TraceRays trace({{"triangle", "triangle/watertight.glsl"},
                         {"structure", find_part("structure", structure)}},
                        2048);
        const std::vector<Hit> hits =
            read_hits(trace.closest_hits(upload_rays(rays), textures), rays.size());
        CHECK(count_impossible(hits, rays, triangle_count(scene)) == 0);
        CHECK(count_hits(hits) > 0); // some of them are rays
    }
}

TEST_CASE("the empty scene has a grid on the GPU", "[04][gpu][hard_case]") {
    const auto context = make_context(ContextKind::automatic);
    const std::vector<Ray> rays{{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end}};
    for (const char* structure : {"grid", "grid_mailbox"}) {
        CHECK(gpu_hits_of(scene_of(Mesh{}), rays, structure).front().triangle == no_triangle);
    }
}

TEST_CASE("the family of grids says what it built", "[04][family]") {
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<glm::vec3> corners = random_triangles(numbers, 100).corners;
    const BuiltStructure built =
        family_of("grid_mailbox").build(corners, {0.0f, {{"resolution", "10"}}});
    const auto fact = [&](const std::string& name) {
        const auto place = std::find_if(built.facts.begin(), built.facts.end(),
                                        [&](const Fact& each) { return each.name == name; });
        REQUIRE(place != built.facts.end());
        return place->value;
    };
    const auto references = static_cast<double>(built.packed.integers.at("grid_references").size());
    const auto starts = static_cast<double>(built.packed.integers.at("grid_starts").size());
    CHECK(fact("cells") == starts - 1.0);
    CHECK(fact("cells") == fact("cells_x") * fact("cells_y") * fact("cells_z"));
    CHECK(fact("references") == references);
    CHECK(fact("references_per_triangle") == references / 100.0);
    CHECK(fact("memory_bytes") == 4.0 * (references + starts));
    CHECK(fact("leaves") > 0.0);
    CHECK(fact("leaves") <= fact("cells"));
}

TEST_CASE("a value that is no number in its range is refused by its name", "[04][family][errors]") {
    const std::vector<glm::vec3> corners(3, glm::vec3(1.0f));
    const auto error_with = [&](const std::string& option, const std::string& value) {
        return error_of([&] { family_of("grid").build(corners, {0.0f, {{option, value}}}); });
    };
    for (const char* option : {"density", "resolution", "memory-limit"}) {
        for (const char* value : {"", "many", "3x", "-1", "1e99", "nan", " 2"}) {
            CAPTURE(option, value);
            CHECK_THAT(error_with(option, value), starts_with_text("--" + std::string(option)));
        }
        CHECK(error_with(option, "2").empty());
    }
    CHECK_THAT(error_with("density", "0"), starts_with_text("--density"));
}
