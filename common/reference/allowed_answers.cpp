#include "reference/allowed_answers.h"

#include "reference/exact.h"
#include "reference/near_triangle.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace raysteps {

namespace {

constexpr float largest = std::numeric_limits<float>::max();

// Boxes are grown by twice the room, which pays for rounding.
constexpr double box_room = 0x1p-18;

} // namespace

AnswerRules::AnswerRules(std::span<const glm::vec3> corners, Arithmetic arithmetic)
    : corners_(corners), arithmetic_(arithmetic), boxes_(corners) {
    std::map<std::tuple<float, float, float>, std::int32_t> numbers;
    for (const glm::vec3& corner : corners) {
        const auto next = static_cast<std::int32_t>(numbers.size());
        points_.push_back(numbers.try_emplace({corner.x, corner.y, corner.z}, next).first->second);
    }
}

std::vector<NearTriangle> AnswerRules::near_triangles(const Ray& ray) const {
    std::vector<NearTriangle> near;
    for (const int number : boxes_.candidates(ray, box_room)) {
        const auto first = 3 * static_cast<std::size_t>(number);
        const std::array corners{corners_[first], corners_[first + 1], corners_[first + 2]};
        NearTriangle one(number, ray, corners, arithmetic_);
        if (one.is_near()) {
            near.push_back(std::move(one));
        }
    }
    return near;
}

namespace {

// Numbers in sets that grow together.
class GrowingSets {
public:
    explicit GrowingSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }

    std::size_t group_of(std::size_t one) const {
        while (parents_[one] != one) {
            one = parents_[one];
        }
        return one;
    }

    void join(std::size_t one, std::size_t other) { parents_[group_of(one)] = group_of(other); }

private:
    std::vector<std::size_t> parents_;
};

// An edge of near triangles, from the point with the smaller number to the other.
struct EdgeUse {
    std::pair<std::int32_t, std::int32_t> points;
    int sign = 0; // 1 where the patch follows it so, -1 where it follows it back
    std::size_t triangle = 0;
    int corner = 0;     // of the triangle, where its own edge begins
    bool is_up = false; // whether that is the first of the points
};

bool lies_in(NearTriangle& triangle, const Ray& ray) {
    return !triangle.begins_before(std::max(ray.t_min, -largest)) &&
           !triangle.ends_behind(std::min(ray.t_max, largest));
}

int turns(NearTriangle& triangle, const EdgeUse& use) {
    const int next = (use.corner + 1) % 3;
    return use.is_up ? triangle.turns(use.corner, next) : triangle.turns(next, use.corner);
}

} // namespace

struct AnswerRules::Patches {
    GrowingSets sets;
    std::vector<EdgeUse> uses; // those of one edge beside each other
};

// Triangles that share edges are one patch. `facing` turns all triangles towards the ray first, and
// takes one of several with the same corners.
AnswerRules::Patches AnswerRules::patches_of(std::span<NearTriangle> near, bool facing) const {
    Patches patches{GrowingSets(near.size()), {}};
    std::map<std::array<std::int32_t, 3>, std::size_t> known;
    for (std::size_t n = 0; n < near.size(); ++n) {
        const auto first = 3 * static_cast<std::size_t>(near[n].number());
        const std::array points{points_[first], points_[first + 1], points_[first + 2]};
        int sign = 1;
        if (facing) {
            std::array sorted = points;
            std::sort(sorted.begin(), sorted.end());
            const auto [same, is_new] = known.try_emplace(sorted, n);
            if (!is_new) {
                patches.sets.join(n, same->second);
                continue;
            }
            sign = near[n].is_clockwise() ? -1 : 1;
        }
        for (int i = 0; i < 3; ++i) {
            const std::int32_t from = points[i];
            const std::int32_t to = points[(i + 1) % 3];
            const int along = from == to ? 0 : from < to ? sign : -sign;
            patches.uses.push_back({std::minmax(from, to), along, n, i, from < to});
        }
    }
    std::stable_sort(
        patches.uses.begin(), patches.uses.end(),
        [](const EdgeUse& one, const EdgeUse& other) { return one.points < other.points; });
    for (std::size_t i = 1; i < patches.uses.size(); ++i) {
        if (patches.uses[i].points == patches.uses[i - 1].points) {
            patches.sets.join(patches.uses[i].triangle, patches.uses[i - 1].triangle);
        }
    }
    return patches;
}

// The border of a patch is what edges are left when those that are followed there and back cancel
// out. Where the border is nowhere near the ray and runs around it, the ray meets the patch,
// however its corners move within the room.
void AnswerRules::find_sure_hits(const Ray& ray, std::span<NearTriangle> near, bool facing,
                                 AllowedAnswer& answer) const {
    const Patches patches = patches_of(near, facing);
    std::vector<bool> is_sure(near.size(), true);
    for (std::size_t n = 0; n < near.size(); ++n) {
        const std::size_t patch = patches.sets.group_of(n);
        is_sure[patch] = is_sure[patch] && lies_in(near[n], ray);
    }
    std::vector<int> around(near.size(), 0);
    for (auto use = patches.uses.begin(); use != patches.uses.end();) {
        const auto behind = std::find_if(
            use, patches.uses.end(), [&](const EdgeUse& one) { return one.points != use->points; });
        const std::size_t patch = patches.sets.group_of(use->triangle);
        int count = 0;
        for (auto one = use; one != behind; ++one) {
            count += one->sign;
        }
        if (count != 0 && is_sure[patch]) {
            is_sure[patch] = std::none_of(use, behind, [&](const EdgeUse& one) {
                return near[one.triangle].is_edge_near(one.corner);
            });
            around[patch] += is_sure[patch] ? count * turns(near[use->triangle], *use) : 0;
        }
        use = behind;
    }
    for (std::size_t patch = 0; patch < near.size(); ++patch) {
        if (patches.sets.group_of(patch) != patch || !is_sure[patch] || around[patch] == 0) {
            continue;
        }
        answer.miss = false;
        std::erase_if(answer.hits, [&](const AllowedHit& hit) {
            for (std::size_t n = 0; n < near.size(); ++n) {
                if (patches.sets.group_of(n) == patch && !near[n].ends_before(hit.t_least)) {
                    return false;
                }
            }
            return true;
        });
    }
}

AllowedAnswer AnswerRules::allowed(const Ray& ray, Origin origin) const {
    if (!is_usable(ray) || ray.direction == glm::vec3(0.0f)) {
        return {.miss = true, .anything = true};
    }
    AllowedAnswer answer{.miss = origin == Origin::anywhere};
    std::vector<NearTriangle> near = near_triangles(ray);
    for (NearTriangle& one : near) {
        const float least = std::max(one.least(), ray.t_min);
        const float most = std::min({one.most(), ray.t_max, largest});
        if (least <= most) {
            answer.hits.push_back({one.number(), least, most});
        }
    }
    for (NearTriangle& one : near) { // each by itself, then together
        find_sure_hits(ray, {&one, 1}, false, answer);
    }
    find_sure_hits(ray, near, false, answer);
    find_sure_hits(ray, near, true, answer);
    return answer;
}

} // namespace raysteps
