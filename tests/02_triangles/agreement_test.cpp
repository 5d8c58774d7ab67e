#include "catch.h"
#include "gpu/context.h"
#include "mirror/every_triangle.h"
#include "mirror/mirror_scene.h"
#include "render/trace_rays.h"

#include <bit>
#include <random>

using namespace raysteps;

namespace {

// Triangles and rays from the unit cube: many hits, many misses.
struct Soup {
    Scene scene;
    std::vector<Ray> rays;
};

Soup make_soup(unsigned seed, int triangles, int rays) {
    std::mt19937 generator(seed);
    const auto number = [&] {
        return static_cast<float>(generator() >> 8) * 0x1p-24f * 2.0f - 1.0f;
    };
    const auto point = [&] { return glm::vec3(number(), number(), number()); };
    Soup soup;
    for (int i = 0; i < triangles; ++i) {
        const glm::vec3 center = point();
        for (int corner = 0; corner < 3; ++corner) {
            soup.scene.corners.push_back(center + 0.3f * point());
            soup.scene.normals.emplace_back(0.0f, 0.0f, 1.0f);
        }
        soup.scene.triangle_materials.push_back(0);
    }
    soup.scene.materials.resize(1);
    for (int i = 0; i < rays; ++i) {
        soup.rays.push_back({2.0f * point(), point(), 0.0f, std::numeric_limits<float>::max()});
    }
    return soup;
}

bool same_bits(const Hit& a, const Hit& b) {
    const auto bits = [](float number) { return std::bit_cast<std::uint32_t>(number); };
    return a.triangle == b.triangle && bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) &&
           bits(a.v) == bits(b.v);
}

template <class Mirror>
std::size_t count_different(const Soup& soup, const std::vector<Hit>& gpu_hits) {
    const mirror::SceneBuffers buffers(soup.scene);
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    std::size_t different = 0;
    for (std::size_t i = 0; i < soup.rays.size(); ++i) {
        const Hit hit =
            mirror::from_mirror(mirror.closest_hit(mirror::to_mirror<Mirror>(soup.rays[i])));
        different += same_bits(hit, gpu_hits[i]) ? 0 : 1;
    }
    return different;
}

} // namespace

TEST_CASE("the GPU and the mirror give the same bits", "[02][agreement]") {
    const unsigned seed = 1;
    CAPTURE(seed);
    const Soup soup = make_soup(seed, 500, 20000);
    const auto context = make_context(ContextKind::automatic);
    const SceneTextures scene = upload(soup.scene);
    const RayTextures rays = upload_rays(soup.rays);
    const auto trace = [&](const std::string& triangle) {
        TraceRays trace_rays({{"triangle", "geometry/triangle_" + triangle + ".glsl"}}, 512);
        return read_hits(trace_rays.closest_hits(rays, scene), soup.rays.size());
    };
    CHECK(count_different<mirror::EveryTriangleWatertight<float>>(soup, trace("watertight")) == 0);
    CHECK(count_different<mirror::EveryTriangleMoellerTrumbore<float>>(
              soup, trace("moeller_trumbore")) == 0);
    const std::vector<Hit> hits = trace("watertight");
    const auto hit_count =
        std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle >= 0; });
    CHECK(hit_count > 1000);
}
