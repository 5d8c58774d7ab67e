#include "catch.h"
#include "gpu/context.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "render/packets.h"
#include "render/show_hits.h"
#include "render/trace_rays.h"
#include "scene/shapes.h"
#include "structure/padding.h"
#include "structure/structure.h"
#include "support/scene_of.h"
#include "support/walk_hits.h"

#include <algorithm>

using namespace raysteps;

namespace {

// A scene with the loop over its triangles, and with what packets walk through.
struct PacketScene {
    explicit PacketScene(Scene of, float reach = 8.0f)
        : scene(std::move(of)), loop(upload(scene)),
          tree(upload(scene, family_of("packet_bvh4").build(scene.corners, {.reach = reach}))) {}

    Scene scene;
    SceneTextures loop;
    SceneTextures tree;
};

Scene ball_and_crumbs(int seed) {
    RandomNumbers numbers(seed);
    return scene_of(join(sphere({0.1f, 0.2f, -0.1f}, 1.2f, 4), random_triangles(numbers, 200)));
}

TraceRays the_loop() {
    return {walk_parts("watertight", "every_triangle"), 1 << 14};
}

TraceRays packets(int rounds_per_launch = 2048) {
    return {walk_parts("watertight", "packet_bvh4"), rounds_per_launch, Packets::always};
}

// A list of rays that are said to be neighbours, whatever they are.
RayTextures upload_neighbours(std::span<const Ray> rays) {
    RayTextures textures = upload_rays(rays);
    textures.coherence = Coherence::neighbours;
    return textures;
}

std::size_t count_other_answers(const std::vector<Hit>& a, const std::vector<Hit>& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        different += (a[i].triangle >= 0) == (b[i].triangle >= 0) ? 0 : 1;
    }
    return different;
}

// Each triangle reaches around all smaller ones, and behind them: inserted one after another, they
// make a tree that is nearly a chain.
Scene nested_triangles(int count) {
    std::vector<glm::vec3> corners;
    float size = 1.0f;
    for (int i = 0; i < count; ++i, size *= 0.7f) {
        corners.insert(corners.end(),
                       {{-size, -size, size}, {size, -size, size}, {0.0f, size, size}});
    }
    return scene_of_corners(corners);
}

} // namespace

TEST_CASE("one packet finds four hits that are known", "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const PacketScene two(scene_of(join(quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}),
                                        quad({-1, -1, -1}, {3, -1, -1}, {3, 1, -1}, {-1, 1, -1}))));
    const glm::vec3 away(0.0f, 0.0f, -1.0f);
    const std::vector<Ray> rays{{{0.5f, -0.5f, 2.0f}, away, 0.0f, no_end},
                                {{2.0f, -0.5f, 2.0f}, away, 0.0f, no_end},
                                {{9.0f, -0.5f, 2.0f}, away, 0.0f, no_end},
                                {{0.5f, -0.5f, 2.0f}, away, 2.5f, no_end}};
    TraceRays trace = packets();
    const std::vector<Hit> hits =
        read_hits(trace.closest_hits(upload_neighbours(rays), two.tree), 4);
    CHECK(trace.went_in_packets());
    CHECK(hits[0].t == 2.0f);
    CHECK(hits[0].triangle == 0);
    CHECK(hits[1].t == 3.0f);
    CHECK(hits[1].triangle == 2);
    CHECK(hits[2].triangle == no_triangle);
    CHECK(hits[3].t == 3.0f);
    CHECK(hits[3].triangle == 2);
}

TEST_CASE("in pictures of any size packets find the bits of the loop", "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const PacketScene ball(ball_and_crumbs(5));
    TraceRays loop = the_loop();
    TraceRays trace = packets();
    for (const auto& [width, height] :
         {std::pair{1, 1}, {2, 1}, {1, 2}, {3, 5}, {64, 48}, {65, 127}, {257, 131}}) {
        CAPTURE(width, height);
        const RayTextures rays =
            generate_rays(ball.scene.camera, width, height, RayGeneration::direct);
        const Texture found = trace.closest_hits(rays, ball.tree);
        REQUIRE(trace.went_in_packets());
        REQUIRE(found.layers() == 4);
        const Texture expected = loop.closest_hits(rays, ball.loop);
        CHECK(count_different(read_hits(found), read_hits(expected)) == 0);
        const auto shown = [&](const Texture& hits) {
            return show_hits(rays, hits, ball.loop, ball.scene.camera, glm::vec3(0.5f),
                             "view/hits.glsl");
        };
        CHECK(shown(found).pixels == shown(expected).pixels); // the passes read both
    }
}

TEST_CASE("packets of rays that go all ways find the bits of the loop", "[render][packets][gpu]") {
    const int seed = 6;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const auto context = make_context(ContextKind::automatic);
    const PacketScene ball(ball_and_crumbs(seed), 100.0f);
    TraceRays loop = the_loop();
    TraceRays trace = packets();
    for (RayFamily& family : ray_families(numbers, ball.scene.corners, 1001)) {
        CAPTURE(family.name);
        REQUIRE(reach_of(family.rays, ball.scene.corners) < 100.0f);
        for (std::size_t i = 0; i < family.rays.size(); i += 7) {
            family.rays[i].t_max = i % 2 == 0 ? -1.0f : 0.75f; // some are empty, some short
        }
        const RayTextures rays = upload_neighbours(family.rays);
        const std::size_t count = family.rays.size();
        const std::vector<Hit> closest = read_hits(loop.closest_hits(rays, ball.loop), count);
        CHECK(count_hits(closest) > count / 100);
        CHECK(count_different(read_hits(trace.closest_hits(rays, ball.tree), count), closest) == 0);
        CHECK(trace.went_in_packets());
        CHECK(count_other_answers(read_hits(trace.any_hits(rays, ball.tree), count), closest) == 0);
    }
}

TEST_CASE("packets with each triangle test find the bits of rays by themselves",
          "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const PacketScene ball(ball_and_crumbs(7));
    const RayTextures rays = generate_rays(ball.scene.camera, 64, 64, RayGeneration::direct);
    for (const NamedPart& triangle : list_parts("triangle")) {
        if (triangle.name == "paper_wrong_depth") {
            continue; // its hits lie elsewhere than their triangles: each walk finds others
        }
        CAPTURE(triangle.name);
        TraceRays together(walk_parts(triangle.name, "packet_bvh4"), 2048, Packets::always);
        TraceRays alone(walk_parts(triangle.name, "bvh4"), 2048);
        CHECK(count_different(read_hits(together.closest_hits(rays, ball.tree)),
                              read_hits(alone.closest_hits(rays, ball.tree))) == 0);
        CHECK(together.went_in_packets());
        CHECK(!alone.went_in_packets());
    }
}

TEST_CASE("packets that a launch cuts go on as rays by themselves", "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const PacketScene ball(ball_and_crumbs(8));
    TraceRays loop = the_loop();
    const RayTextures rays = generate_rays(ball.scene.camera, 63, 61, RayGeneration::direct);
    const std::vector<Hit> closest = read_hits(loop.closest_hits(rays, ball.loop));
    for (const int rounds : {1, 3, 12, 40}) {
        CAPTURE(rounds);
        TraceRays trace = packets(rounds);
        CHECK(count_different(read_hits(trace.closest_hits(rays, ball.tree)), closest) == 0);
        CHECK(trace.launch_count() > 1);
        CHECK(count_other_answers(read_hits(trace.any_hits(rays, ball.tree)), closest) == 0);
    }
}

TEST_CASE("packets that run out of stack go on as rays by themselves", "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = nested_triangles(90);
    std::vector<Ray> through_all;
    for (int i = 0; i < 77; ++i) {
        through_all.push_back(
            {{static_cast<float>(i) * 1e-14f, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end});
    }
    const SceneTextures deep =
        upload(scene, family_of("bvh4").build(scene.corners,
                                              {.reach = 8.0f,
                                               .values = {{"leaf-triangles", "1"},
                                                          {"split", "insertion"},
                                                          {"insertion-order", "as_given"}}}));
    TraceRays trace = packets();
    const RayTextures rays = upload_neighbours(through_all);
    const std::vector<Hit> found = read_hits(trace.closest_hits(rays, deep), through_all.size());
    CHECK(trace.went_in_packets());
    CHECK(trace.launch_count() == 2); // of packets, and of those that had no room
    const std::vector<Hit> expected =
        read_hits(the_loop().closest_hits(rays, upload(scene)), through_all.size());
    CHECK(count_hits(expected) == through_all.size());
    CHECK(count_different(found, expected) == 0);
}

TEST_CASE("under a mask packets find the hits of its live pixels", "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const PacketScene ball(ball_and_crumbs(9));
    TraceRays loop = the_loop();
    const RayTextures rays = generate_rays(ball.scene.camera, 65, 63, RayGeneration::direct);
    LiveMask live(65, 63);
    const Texture all = loop.closest_hits(rays, ball.loop);
    Program misses("pass/select/select_misses.frag");
    retire(live, misses.set("hits", all)); // so a pixel is live where its ray hits
    const std::vector<Hit> expected = read_hits(all);
    for (const int rounds : {2048, 20}) {
        CAPTURE(rounds);
        TraceRays trace = packets(rounds);
        const std::vector<Hit> found = read_hits(trace.closest_hits(rays, ball.tree, &live));
        CHECK(trace.went_in_packets());
        std::size_t different = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            if (expected[i].triangle >= 0) {
                different += same_bits(found[i], expected[i]) ? 0 : 1;
            }
        }
        CHECK(different == 0);
    }
}

TEST_CASE("nobody who observes, counts in double precision or goes alone is put in a packet",
          "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const PacketScene ball(ball_and_crumbs(10));
    RayTextures rays = generate_rays(ball.scene.camera, 16, 16, RayGeneration::direct);
    const std::vector<Hit> expected = read_hits(the_loop().closest_hits(rays, ball.loop));
    Parts observed = walk_parts("watertight", "packet_bvh4");
    observed["observer"] = "observer/count.glsl";
    TraceRays observing(observed, 2048, Packets::always);
    CHECK(count_different(read_hits(observing.closest_hits(rays, ball.tree)), expected) == 0);
    CHECK(!observing.went_in_packets());
    CHECK(std::ranges::any_of(read_integers(*observing.observations()),
                              [](const glm::uvec4& texel) { return texel.x > 0; }));
    Parts doubled = walk_parts("watertight_rounded", "packet_bvh4");
    doubled["real"] = "exhibit/double_precision.glsl";
    TraceRays in_double(doubled, 2048, Packets::always);
    in_double.closest_hits(rays, ball.tree);
    CHECK(!in_double.went_in_packets());
    TraceRays trace = packets();
    rays.coherence = Coherence::alone;
    CHECK(count_different(read_hits(trace.closest_hits(rays, ball.tree)), expected) == 0);
    CHECK(!trace.went_in_packets());
}

TEST_CASE("where packets are left to the machine, small pictures go ray by ray",
          "[render][packets][gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const PacketScene ball(ball_and_crumbs(11));
    TraceRays trace(walk_parts("watertight", "fastest"), 2048);
    TraceRays alone(walk_parts("watertight", "bvh4"), 2048);
    trace.closest_hits(generate_rays(ball.scene.camera, 64, 64, RayGeneration::direct), ball.tree);
    CHECK(!trace.went_in_packets());
    const int height = 2;
    const auto width = static_cast<int>(least_rays_for_packets() / height);
    const RayTextures many =
        generate_rays(ball.scene.camera, std::min(width, 16384),
                      std::max(height, width / 16384 * height), RayGeneration::direct);
    // Whichever way is the faster one on this machine: the hits are the same.
    CHECK(count_different(read_hits(trace.closest_hits(many, ball.tree)),
                          read_hits(alone.closest_hits(many, ball.tree))) == 0);
}
