#include "basics/error.h"
#include "hard_cases/aimed_rays.h"
#include "mirror/trace_by_mirror.h"
#include "mirror/walks.h"
#include "structure/bvh/build_bvh.h"
#include "trials.h"

#include <limits>

namespace raysteps {

namespace {

constexpr int usual_boxes = 100000;

using BoxTest = bool (*)(const Ray& ray, const Box& box);

std::size_t count_wrong(std::span<const AimedBox> aimed, BoxTest meets) {
    std::size_t wrong = 0;
    for (const AimedBox& one : aimed) {
        wrong += meets(one.ray, one.box) == one.meets ? 0 : 1;
    }
    return wrong;
}

enum class PlainBox { promised, reported };

std::vector<TrialRow> try_both(std::span<const AimedBox> aimed, PlainBox plain) {
    const auto row = plain == PlainBox::promised ? promised_row : reported_row;
    return {row("box_plain", "C++", "the true answer", count_wrong(aimed, meets_plain_box),
                aimed.size()),
            promised_row("box_padded", "C++", "the true answer",
                         count_wrong(aimed, meets_padded_box), aimed.size())};
}

int boxes_of(const TrialTools& tools) {
    return tools.rays > 0 ? tools.rays : usual_boxes;
}

std::vector<TrialRow> corners_of_flat_boxes(const TrialTools& tools) {
    RandomNumbers numbers(tools.seed);
    std::vector<AimedBox> aimed = rays_at_corners_of_any_box(numbers, boxes_of(tools));
    for (const AimedBox& touched : rays_that_touch_a_box(numbers, boxes_of(tools))) {
        aimed.push_back(touched);
    }
    std::vector<TrialRow> rows = try_both(aimed, PlainBox::reported);
    for (AimedBox& one : aimed) {
        one.box = grown_by_roundings(one.box);
    }
    rows.push_back(promised_row("box_plain, box grown", "C++", "the true answer",
                                count_wrong(aimed, meets_plain_box), aimed.size()));
    return rows;
}

std::vector<TrialRow> empty_box(const TrialTools& tools) {
    RandomNumbers numbers(tools.seed);
    const std::vector<AimedBox> aimed = rays_at_the_empty_box(numbers, boxes_of(tools) / 20);
    std::vector<TrialRow> rows{promised_row("box_plain", "C++", "never visited",
                                            count_wrong(aimed, meets_plain_box), aimed.size())};
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    std::size_t built = 1;
    try {
        build_bvh(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, not_a_number, 0}}, {});
    } catch (const InputError&) {
        built = 0;
    }
    rows.push_back(promised_row("build_bvh", "C++", "refuses NaN", built, 1));
    return rows;
}

} // namespace

std::vector<Trial> box_checks() {
    const char* ize = "Ize, Robust BVH Ray Traversal, 2013";
    return {
        {"B1", "rays in the planes of a box's sides: a box is closed", "",
         "choose near and far planes by the sign of the direction",
         [](const TrialTools&) { return try_both(rays_in_sides_of_a_box(), PlainBox::promised); }},
        {"B2", "rays at corners of flat boxes, and rays that only touch a box", ize,
         "pad boxes when they are built, or the test", corners_of_flat_boxes},
        {"B3", "a box a million sides away from zero", "",
         "(plane - origin) * inverse, not plane * inverse - origin * inverse",
         [](const TrialTools&) { return try_both(rays_far_from_zero(), PlainBox::promised); }},
        {"B4", "boxes behind and around the origin, and at the ends of a ray", "", "",
         [](const TrialTools&) {
             const std::vector<AimedBox> aimed = rays_that_end_at_a_box();
             return std::vector<TrialRow>{promised_row("box_plain", "C++", "the true answer",
                                                       count_wrong(aimed, meets_plain_box),
                                                       aimed.size())};
         }},
        {"B5", "the empty box, and one with a NaN", "", "", empty_box},
    };
}

} // namespace raysteps
