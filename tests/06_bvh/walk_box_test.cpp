#include "build_trees.h"
#include "bvh_hits.h"
#include "catch.h"
#include "support/error_of.h"

#include <array>

using namespace raysteps;

namespace {

// Whether the box test of the mirror visits the box: the part alone, so nothing is padded.
template <class Mirror>
bool meets(const Ray& ray, const Box& box) {
    Mirror mirror{};
    typename Mirror::BvhNode node{};
    node.first_planes = box.lower;
    node.last_planes = box.upper;
    return mirror.meets_bvh_node(mirror.box_ray(mirror::to_mirror<Mirror>(ray)), node, ray.t_max);
}

bool meets_plain(const Ray& ray, const Box& box) {
    return meets<mirror::BvhSkip<float>>(ray, box);
}

bool meets_padded(const Ray& ray, const Box& box) {
    return meets<mirror::BvhSkipPadded<float>>(ray, box);
}

const Box unit_box{glm::vec3(0.0f), glm::vec3(1.0f)};

// A multiple of 2^-9 between -2 and 2: differences of such numbers are floats, so a ray from one
// lattice point to another is exact.
glm::vec3 lattice_point(RandomNumbers& numbers) {
    const auto coordinate = [&] {
        return static_cast<float>(numbers.below(2048) - 1024) * 0x1p-9f;
    };
    const float x = coordinate();
    const float y = coordinate();
    return {x, y, coordinate()};
}

// A box, flat along one axis or none, with a ray that truly meets it, in one corner.
struct AimedBox {
    Ray ray;
    Box box;
};

AimedBox aimed_box(RandomNumbers& numbers) {
    Box box = bounds_of(std::array{lattice_point(numbers), lattice_point(numbers)});
    const int flat_axis = numbers.below(4);
    if (flat_axis < 3) {
        box.upper[flat_axis] = box.lower[flat_axis];
    }
    glm::vec3 corner;
    for (int axis = 0; axis < 3; ++axis) {
        corner[axis] = numbers.below(2) == 0 ? box.lower[axis] : box.upper[axis];
    }
    const glm::vec3 origin = lattice_point(numbers);
    return {{origin, corner - origin, 0.0f, no_end}, box};
}

} // namespace

TEST_CASE("B1 a box is closed for rays in the planes of its sides", "[06][hard_case]") {
    for (int along = 0; along < 3; ++along) {
        for (int aside = 0; aside < 3; ++aside) {
            for (const float place : {0.0f, 1.0f}) {
                for (const float zero : {0.0f, -0.0f}) {
                    for (const float sign : {1.0f, -1.0f}) {
                        if (aside == along) {
                            continue;
                        }
                        Ray ray{glm::vec3(0.5f), glm::vec3(zero), 0.0f, no_end};
                        ray.origin[along] = 0.5f - 1.5f * sign;
                        ray.direction[along] = sign;
                        ray.origin[aside] = place;
                        CAPTURE(along, aside, place, zero, sign);
                        CHECK(meets_plain(ray, unit_box));
                        CHECK(meets_padded(ray, unit_box));
                        ray.t_min = -no_end;
                        CHECK(meets_plain(ray, unit_box));
                        ray.origin[aside] = place == 0.0f ? -1e-6f : 1.000001f;
                        CHECK_FALSE(meets_plain(ray, unit_box));
                        CHECK_FALSE(meets_padded(ray, unit_box));
                    }
                }
            }
        }
    }
}

TEST_CASE("B2 room of two units in the last place is enough for boxes that are not padded",
          "[06][hard_case]") {
    const int seed = 31;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    int missed_by_plain = 0;
    int missed_by_padded = 0;
    for (int i = 0; i < 100000; ++i) {
        const AimedBox aimed = aimed_box(numbers);
        missed_by_plain += meets_plain(aimed.ray, aimed.box) ? 0 : 1;
        missed_by_padded += meets_padded(aimed.ray, aimed.box) ? 0 : 1;
    }
    CHECK(missed_by_padded == 0);
    CHECK(missed_by_plain > 1000); // so the rays are worth their name
}

TEST_CASE("B2 a box grown by nine roundings is not missed by the plain test", "[06][hard_case]") {
    const int seed = 32;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    int missed = 0;
    for (int i = 0; i < 100000; ++i) {
        AimedBox aimed = aimed_box(numbers);
        const float reach = 4.0f; // between two lattice points
        aimed.box.lower -= 9.0f * 0x1p-24f * reach;
        aimed.box.upper += 9.0f * 0x1p-24f * reach;
        missed += meets_plain(aimed.ray, aimed.box) ? 0 : 1;
    }
    CHECK(missed == 0);
}

TEST_CASE("B3 at an offset of a million the box test is as sharp as at zero", "[06][hard_case]") {
    // plane * inverse - origin * inverse would have an error of 0.06 here, at a side of 1.
    const glm::vec3 offset(1e6f);
    const Box box{offset, offset + 1.0f};
    for (int axis = 0; axis < 3; ++axis) {
        // Enters the box at its lower corner, at t = 1 / 0.3.
        Ray ray{offset + glm::vec3(-1.0f), glm::vec3(0.3f), 0.0f, no_end};
        CHECK(meets_plain(ray, box));
        ray.t_max = 3.334f;
        CHECK(meets_plain(ray, box));
        ray.t_max = 3.333f;
        CHECK_FALSE(meets_plain(ray, box));
        ray.t_max = no_end;
        ray.origin[axis] -= 1.25f;
        CHECK_FALSE(meets_plain(ray, box));
    }
}

TEST_CASE("B4 boxes behind and around the origin and at the very end of a ray", "[06][hard_case]") {
    Ray ray{{0.5f, 0.5f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end};
    CHECK(meets_plain(ray, unit_box));
    ray.t_max = 1.0f; // the entry
    CHECK(meets_plain(ray, unit_box));
    ray.t_max = 0x1.fffffep-1f; // just before
    CHECK_FALSE(meets_plain(ray, unit_box));
    ray.t_max = no_end;
    ray.t_min = 2.0f; // the exit
    CHECK(meets_plain(ray, unit_box));
    ray.t_min = 0x1.000002p+1f;
    CHECK_FALSE(meets_plain(ray, unit_box));
    ray.t_min = 0.0f;
    ray.origin = glm::vec3(0.5f);
    CHECK(meets_plain(ray, unit_box));
    ray.origin.z = 1.5f; // behind
    CHECK_FALSE(meets_plain(ray, unit_box));
    CHECK_FALSE(meets_padded(ray, unit_box));
    ray.t_min = -1.0f; // the part before the origin counts as well
    CHECK(meets_plain(ray, unit_box));
    CHECK(meets_padded(ray, unit_box));
}

TEST_CASE("B5 an empty box is never visited and one that is no number never built",
          "[06][hard_case]") {
    const int seed = 35;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    int visited = 0;
    for (const Ray& ray : random_rays(numbers, 1000)) {
        visited += meets_plain(ray, Box{}) ? 1 : 0;
    }
    for (const Ray& ray : axis_parallel_rays(numbers, std::array{glm::vec3(0.0f)}, 1000)) {
        visited += meets_plain(ray, Box{}) ? 1 : 0;
    }
    CHECK(visited == 0);
    const std::vector<glm::vec3> corners{
        {0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<float>::quiet_NaN(), 0}};
    CHECK_FALSE(error_of([&] { build_bvh(corners, {}); }).empty());
}
