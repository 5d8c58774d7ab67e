#include "basics/text.h"
#include "trade_offs.h"

#include "basics/box.h"
#include "basics/random_numbers.h"
#include "gpu/draw.h"
#include "gpu/gl.h"
#include "gpu/shaders.h"
#include "hard_cases/aimed_rays.h"
#include "reference/exact.h"
#include "render/rays.h"

#include <algorithm>
#include <memory>

namespace raysteps {

namespace {

constexpr int box_count = 128; // as many as pass/trace/meet_boxes.frag has bits for

// Rays that each were aimed at one of the boxes.
struct BoxFamily {
    std::string name;
    std::vector<Box> boxes;
    std::vector<Ray> rays;
    std::vector<int> aimed_at;
    std::vector<bool> truth;
};

std::vector<Box> make_boxes(RandomNumbers& numbers, const glm::vec3& place, float thickness) {
    std::vector<Box> boxes;
    for (int i = 0; i < box_count; ++i) {
        const glm::vec3 lower = place + numbers.in_cube();
        glm::vec3 size = 0.25f * (0.5f * numbers.in_cube() + 0.5f);
        size[numbers.below(3)] *= thickness;
        boxes.push_back({lower, lower + size});
    }
    return boxes;
}

glm::vec3 corner_of(RandomNumbers& numbers, const Box& box) {
    return {numbers.below(2) == 0 ? box.lower.x : box.upper.x,
            numbers.below(2) == 0 ? box.lower.y : box.upper.y,
            numbers.below(2) == 0 ? box.lower.z : box.upper.z};
}

Ray at_inside(RandomNumbers& numbers, const Box& box, const glm::vec3& place) {
    const glm::vec3 share = 0.5f * numbers.in_cube() + 0.5f;
    const glm::vec3 origin = place + 2.0f * numbers.in_cube();
    return {origin, box.lower + share * (box.upper - box.lower) - origin, 0.0f, no_end};
}

Ray at_corner(RandomNumbers& numbers, const Box& box, const glm::vec3& place) {
    const glm::vec3 origin = place + 2.0f * numbers.in_cube();
    return {origin, corner_of(numbers, box) - origin, 0.0f, no_end};
}

// Past a corner, within the box by a share of its size.
Ray inside_corner(RandomNumbers& numbers, const Box& box, const glm::vec3& place) {
    const glm::vec3 corner = corner_of(numbers, box);
    const glm::vec3 middle = 0.5f * (box.lower + box.upper);
    const glm::vec3 origin = place + 2.0f * numbers.in_cube();
    return {origin, corner + 0.001f * (middle - corner) - origin, 0.0f, no_end};
}

// Along an axis, in the plane of a side.
Ray along_side(RandomNumbers& numbers, const Box& box, const glm::vec3& place) {
    const int axis = numbers.below(3);
    glm::vec3 origin = corner_of(numbers, box);
    const int other = (axis + 1) % 3;
    origin[other] +=
        numbers.unit() * (0.5f * (box.lower[other] + box.upper[other]) - origin[other]);
    origin[axis] = place[axis] + (numbers.below(2) == 0 ? 3.0f : -3.0f);
    glm::vec3 direction(0.0f);
    direction[axis] = origin[axis] > place[axis] ? -1.0f : 1.0f;
    return {origin, direction, 0.0f, no_end};
}

using Aim = Ray (*)(RandomNumbers& numbers, const Box& box, const glm::vec3& place);

BoxFamily make_family(const std::string& name, float thickness, const glm::vec3& place, Aim aim,
                      const Effort& effort) {
    RandomNumbers numbers(effort.seed);
    BoxFamily family{name, make_boxes(numbers, place, thickness), {}, {}, {}};
    for (std::size_t i = 0; i < effort.judged_rays; ++i) {
        const int target = numbers.below(box_count);
        const Box& box = family.boxes[static_cast<std::size_t>(target)];
        family.rays.push_back(aim(numbers, box, place));
        family.aimed_at.push_back(target);
        family.truth.push_back(exact_meets_box(family.rays.back(), box));
    }
    return family;
}

BufferTexture upload_boxes(std::span<const Box> boxes) {
    std::vector<glm::vec4> texels;
    for (const Box& box : boxes) {
        texels.emplace_back(box.lower, 0.0f);
        texels.emplace_back(box.upper, 0.0f);
    }
    return BufferTexture(texels);
}

// All rays against all boxes: the bits of the boxes that each meets.
class MeetBoxes {
public:
    MeetBoxes(const std::string& part, const BoxFamily& family, std::size_t ray_count)
        : program_("pass/trace/meet_boxes.frag", {{"slab", part}}),
          boxes_(upload_boxes(family.boxes)), ray_count_(ray_count),
          rays_(upload_rays(std::span(family.rays).first(ray_count))),
          met_(TexelFormat::rgba32ui, rays_.origins.width(), rays_.origins.height()) {
        program_.set("ray_origins", rays_.origins)
            .set("ray_directions", rays_.directions)
            .set("boxes", boxes_)
            .set("box_count", box_count);
    }

    void run() {
        draw(program_, {.textures = {met_}});
        glFinish();
    }
    std::vector<glm::uvec4> met() const { return read_list(met_, ray_count_); }

private:
    Program program_;
    BufferTexture boxes_;
    std::size_t ray_count_;
    RayTextures rays_;
    Texture met_;
};

Findings judge_boxes(std::span<const glm::uvec4> met, const BoxFamily& family) {
    Fault missed{"missed", 0, family.rays.size()};
    double in_vain = 0.0;
    for (std::size_t i = 0; i < family.rays.size(); ++i) {
        const int box = family.aimed_at[i];
        const bool meets = (met[i][box / 32] >> (box % 32) & 1U) != 0;
        missed.count += family.truth[i] && !meets ? 1 : 0;
        in_vain += !family.truth[i] && meets ? 1.0 : 0.0;
    }
    return {{missed}, std::nullopt, {{"in vain", in_vain}}};
}

} // namespace

TradeOffTrials slab_trade_off(const Effort& effort) {
    const glm::vec3 zero(0.0f);
    const std::vector<BoxFamily> families{
        make_family("inside", 1.0f, zero, at_inside, effort),
        make_family("corner", 1.0f, zero, at_corner, effort),
        make_family("corner of a flat box", 0.0f, zero, at_corner, effort),
        make_family("along a side", 1.0f, zero, along_side, effort),
        make_family("corner, 1000 from zero", 1.0f, glm::vec3(1000.0f), at_corner, effort),
        make_family("inside a corner, 1000 from zero", 1.0f, glm::vec3(1000.0f), inside_corner,
                    effort)};
    TradeOffTrials trade_off;
    trade_off.name = "slab";
    trade_off.question = "Does a ray meet a box?";
    trade_off.unit_of_cases = "test";
    const std::size_t timed = std::min(effort.timed_rays, effort.judged_rays);
    for (const BoxFamily& family : families) {
        const auto own = std::make_shared<const BoxFamily>(family);
        for (const NamedPart& part : list_parts("slab")) {
            const auto meet = std::make_shared<MeetBoxes>(part.file, family, timed);
            trade_off.trials.push_back({.method = spoken(part.name),
                                        .family = family.name,
                                        .timed_cases = timed * box_count,
                                        .run = [meet] { meet->run(); },
                                        .examine =
                                            [own, file = part.file] {
                                                MeetBoxes all(file, *own, own->rays.size());
                                                all.run();
                                                return judge_boxes(all.met(), *own);
                                            }});
        }
    }
    return trade_off;
}

} // namespace raysteps
