#include "box_tests.h"

#include "mirror/walks.h"

namespace raysteps {

namespace {

template <class Mirror>
bool meets(const Ray& ray, const Box& box) {
    Mirror mirror{};
    typename Mirror::BvhNode node{};
    node.first_planes = box.lower;
    node.last_planes = box.upper;
    return mirror.meets_bvh_node(mirror.box_ray(mirror::to_mirror<Mirror>(ray)), node, ray.t_max);
}

} // namespace

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
