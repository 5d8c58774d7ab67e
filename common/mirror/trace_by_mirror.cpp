#include "mirror/trace_by_mirror.h"

#include "basics/threads.h"
#include "mirror/walks.h"

namespace raysteps {

namespace {

constexpr std::size_t rays_per_part = 1024;
constexpr int most_rounds = 1 << 26; // more than any walk here needs

template <class Mirror>
Hit hit_of(Mirror& mirror, const Ray& ray) {
    const auto own = mirror::to_mirror<Mirror>(ray);
    auto walk = mirror.start_walk(own);
    if (!walk.ended) {
        walk = mirror.go_on(walk, own, -mirror.farthest, most_rounds);
    }
    Hit hit = mirror::from_mirror(walk.nearest);
    hit.triangle = walk.ended ? hit.triangle : no_answer;
    return hit;
}

template <class Mirror>
std::vector<Hit> trace(const mirror::SceneBuffers& scene, const PackedStructure& structure,
                       std::span<const Ray> rays) {
    const auto shared = mirror::mirror_of<Mirror>(scene, structure);
    std::vector<Hit> hits(rays.size());
    in_parts(all_cores, rays.size(), rays_per_part, [&](std::size_t begin, std::size_t end) {
        Mirror own = shared;
        for (std::size_t i = begin; i < end; ++i) {
            hits[i] = hit_of(own, rays[i]);
        }
    });
    return hits;
}

template <class Mirror>
bool meets(const Ray& ray, const Box& box) {
    Mirror mirror{};
    typename Mirror::BvhNode node{};
    node.first_planes = box.lower;
    node.last_planes = box.upper;
    return mirror.meets_bvh_node(mirror.box_ray(mirror::to_mirror<Mirror>(ray)), node, ray.t_max);
}

} // namespace

const std::map<std::string, TraceByMirror>& mirror_walks() {
#define WALK(name) {#name, trace<mirror::walks::name<float>>},
    static const std::map<std::string, TraceByMirror> walks{ALL_WALKS};
#undef WALK
    return walks;
}

const std::map<std::string, TraceByMirror>& mirror_triangle_tests() {
#define TRIANGLE_TEST(name) {#name, trace<mirror::triangle_tests::name<float>>},
    static const std::map<std::string, TraceByMirror> tests{
        ALL_TRIANGLE_TESTS //
        {"watertight_double", trace<mirror::triangle_tests::watertight<double>>},
        {"moeller_trumbore_double", trace<mirror::triangle_tests::moeller_trumbore<double>>}};
#undef TRIANGLE_TEST
    return tests;
}

bool meets_plain_box(const Ray& ray, const Box& box) {
    return meets<mirror::walks::bvh_skip<float>>(ray, box);
}

bool meets_padded_box(const Ray& ray, const Box& box) {
    return meets<mirror::walks::bvh_skip_padded<float>>(ray, box);
}

Box grown_by_roundings(const Box& box) {
    const float reach = 4.0f;
    const float room = 9.0f * 0x1p-24f * reach;
    return {box.lower - room, box.upper + room};
}

} // namespace raysteps
