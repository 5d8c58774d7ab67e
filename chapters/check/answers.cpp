#include "answers.h"

#include "basics/error.h"
#include "basics/text.h"
#include "mirror/left_out.h"
#include "mirror/trace_by_mirror.h"
#include "reference/allowed_answers.h"
#include "reference/exact.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/check_bvh.h"
#include "structure/padding.h"
#include "why.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raysteps {

namespace {

constexpr std::size_t most_causes = 100000;

std::vector<Hit> through_own_tree(const Scene& scene, const mirror::SceneBuffers& buffers,
                                  std::span<const Ray> rays) {
    BvhOptions options;
    options.reach = static_cast<double>(reach_of(rays, scene.corners));
    const Bvh4 own = collapse(build_bvh(scene.corners, options));
    if (const auto faults = check_bvh4(own, scene.corners); !faults.empty()) {
        throw Error(ExitCode::check_failed, "our own tree is wrong, which is a bug in Raysteps; "
                                            "please report it: " +
                                                faults.front());
    }
    return mirror_walks().at("bvh4")(buffers, pack(own, scene.corners), rays);
}

// Has the loop and exact arithmetic judge our own answers beside those given. Throws where it is
// we who are wrong.
std::size_t confirm(const Scene& scene, const mirror::SceneBuffers& buffers,
                    std::span<const Ray> rays, const std::vector<Hit>& given,
                    const std::vector<Hit>& own) {
    const std::string our_name = "Raysteps' own tree";
    std::vector<std::size_t> all(rays.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const RayKind kind{.name = "given", .rays = {rays.begin(), rays.end()}};
    const std::vector<Answers> answers{{"what is checked", all, given}, {our_name, all, own}};
    const PackedStructure loop = every_triangle(triangle_count(scene)).packed;
    Judgement judgement = judge(scene, kind, answers, [&](const RayKind& some) {
        return mirror_triangle_tests().at("watertight")(buffers, loop, some.rays);
    });
    if (judgement.dispute) {
        for (const Disagreement& one : judgement.dispute->disagreements) {
            if (one.one == our_name && one.other == the_loop) {
                throw DisputeError(std::move(*judgement.dispute));
            }
        }
    }
    return judgement.judged.back();
}

struct Packed {
    std::string walk;
    PackedStructure structure;
};

Packed packed_for_walk(const AnyTree& tree, std::span<const glm::vec3> corners) {
    if (const auto* const kd_tree = std::get_if<KdTree>(&tree)) {
        return {"kd_ropes", pack(*kd_tree)};
    }
    if (const auto* const grid = std::get_if<Grid>(&tree)) {
        return {"grid", pack(*grid)};
    }
    const auto& boxes = std::get<BoxTree>(tree);
    const std::size_t triangles = corners.size() / 3;
    return boxes.width == 2 ? Packed{"bvh_ordered", pack(bvh_of(boxes, triangles), corners)}
                            : Packed{"bvh4", pack(bvh4_of(boxes, triangles), corners)};
}

std::string name_of(const Hit& hit) {
    return hit.triangle < 0 ? "no hit" : fmt::format("triangle {} at {:.9g}", hit.triangle, hit.t);
}

WrongAnswer with_cause(WrongAnswer wrong, const BoxTree& tree, const TreePaths& paths,
                       const Scene& scene, const Ray& ray) {
    if (wrong.right.triangle < 0) {
        wrong.cause = "the ray meets nothing";
        return wrong;
    }
    const LeftOut out =
        left_out(tree, paths, scene.corners, ray, wrong.right.t, wrong.right.triangle);
    switch (out.by) {
    case LeftOutBy::no_leaf:
        wrong.cause = "no leaf lists it";
        break;
    case LeftOutBy::short_box:
        wrong.cause = fmt::format("the box of node {} does not hold it", out.node);
        break;
    case LeftOutBy::tight_box:
        wrong.cause = fmt::format("slips through the tight box of node {}", out.node);
        wrong.is_fault = false;
        break;
    case LeftOutBy::nothing:
        wrong.cause = "the walk comes to it, and answers otherwise";
        break;
    }
    return wrong;
}

} // namespace

std::vector<Hit> hits_through(const AnyTree& tree, const Scene& scene, std::span<const Ray> rays) {
    const mirror::SceneBuffers buffers(scene);
    const Packed packed = packed_for_walk(tree, scene.corners);
    return mirror_walks().at(packed.walk)(buffers, packed.structure, rays);
}

AnswerCheck check_walks(const AnyTree& tree, const Scene& scene, std::span<const Ray> rays) {
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> given = hits_through(tree, scene, rays);
    const std::vector<Hit> own = through_own_tree(scene, buffers, rays);
    AnswerCheck check{.rays = rays.size()};
    check.judged = confirm(scene, buffers, rays, given, own);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!is_same_answer(given[i], own[i], Query::closest)) {
            check.wrong.push_back({i, given[i], own[i], "the structure does not lead to it"});
        }
    }
    if (const auto* const boxes = std::get_if<BoxTree>(&tree)) {
        const TreePaths paths = paths_of(*boxes, scene.corners.size() / 3);
        for (std::size_t i = 0; i < std::min(check.wrong.size(), most_causes); ++i) {
            check.wrong[i] =
                with_cause(check.wrong[i], *boxes, paths, scene, rays[check.wrong[i].ray]);
        }
    }
    return check;
}

namespace {

std::array<glm::vec3, 3> triangle_at(const Scene& scene, int triangle) {
    const auto first = 3 * static_cast<std::size_t>(triangle);
    return {scene.corners[first], scene.corners[first + 1], scene.corners[first + 2]};
}

// Of a segment, the point that is nearest.
double distance_to_edge(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 edge = b - a;
    const double square = glm::dot(edge, edge);
    const double share =
        square > 0.0 ? std::clamp(glm::dot(point - a, edge) / square, 0.0, 1.0) : 0.0;
    return glm::length(point - (a + share * edge));
}

// How far the hit's point is from the triangle that it names. Its t may be off by more: where the
// ray grazes the triangle, a little aside is a long way along.
double distance_from(const std::array<glm::vec3, 3>& triangle, const Ray& ray, float t) {
    const glm::dvec3 a(triangle[0]);
    const glm::dvec3 b(triangle[1]);
    const glm::dvec3 c(triangle[2]);
    const glm::dvec3 point =
        glm::dvec3(ray.origin) + static_cast<double>(t) * glm::dvec3(ray.direction);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const bool above = glm::dot(glm::cross(b - a, point - a), normal) >= 0.0 &&
                       glm::dot(glm::cross(c - b, point - b), normal) >= 0.0 &&
                       glm::dot(glm::cross(a - c, point - c), normal) >= 0.0;
    if (above && normal != glm::dvec3(0.0)) {
        return std::abs(glm::dot(point - a, glm::normalize(normal)));
    }
    return std::min({distance_to_edge(point, a, b), distance_to_edge(point, b, c),
                     distance_to_edge(point, c, a)});
}

double longest_component(const Ray& ray) {
    return static_cast<double>(std::max(
        {std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)}));
}

// What is wrong with a hit, of which ours is right; empty where rounding explains the difference.
std::string fault_of(const Hit& given, const Hit& right, const Scene& scene,
                     const AnswerRules& rules, const Ray& ray, double padding) {
    if (given.triangle >= triangle_count(scene) || given.triangle < no_triangle) {
        return "the scene has no such triangle";
    }
    if (given.triangle == no_triangle && right.triangle == no_triangle) {
        return "";
    }
    const auto allowed = [&] { return rules.allowed(ray, AnswerRules::Origin::anywhere); };
    if (given.triangle == no_triangle) { // a ray may slip by a border, and not through a surface
        return allowed().miss ? "" : fmt::format("triangle {} is missed", right.triangle);
    }
    const auto exact_of = [&](int triangle) {
        return exact_intersection(ray, triangle_at(scene, triangle));
    };
    const auto at_edge = [](const ExactIntersection& exact) { return exact.margin < edge_share; };
    const ExactIntersection found = exact_of(given.triangle);
    if (!found.hit && !at_edge(found)) {
        return fmt::format("the ray does not meet triangle {}", given.triangle);
    }
    if (!(distance_from(triangle_at(scene, given.triangle), ray, given.t) <= padding)) {
        return fmt::format("the ray meets triangle {} at {:.9g}", given.triangle, found.t);
    }
    if (right.triangle == no_triangle || right.triangle == given.triangle) {
        return "";
    }
    const ExactIntersection nearest = exact_of(right.triangle);
    const double room = 2.0 * padding / longest_component(ray);
    if (!nearest.hit || found.t <= nearest.t + room) {
        return "";
    }
    const auto is_given = [&](const AllowedHit& hit) { return hit.triangle == given.triangle; };
    return at_edge(nearest) && std::ranges::any_of(allowed().hits, is_given)
               ? ""
               : fmt::format("triangle {} is nearer", right.triangle);
}

} // namespace

AnswerCheck check_hits(std::span<const Hit> hits, const Scene& scene, std::span<const Ray> rays) {
    if (hits.size() != rays.size()) {
        throw InputError("--judge: there are " + std::to_string(hits.size()) + " hits for " +
                         std::to_string(rays.size()) + " rays. A file has one for each.");
    }
    const mirror::SceneBuffers buffers(scene);
    const double padding = padding_for(
        usual_reach(bounds_of(scene.corners), static_cast<double>(reach_of(rays, scene.corners))));
    const std::vector<Hit> own = through_own_tree(scene, buffers, rays);
    const AnswerRules rules(scene.corners);
    AnswerCheck check{.rays = rays.size()};
    std::vector<Hit> judged = own; // with those that differ beyond rounding
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::string fault = fault_of(hits[i], own[i], scene, rules, rays[i], padding);
        if (!fault.empty()) {
            check.wrong.push_back({i, hits[i], own[i], fault});
            judged[i] = hits[i];
        } else if (hits[i].triangle != own[i].triangle) {
            ++check.by_rounding;
        }
    }
    check.judged = confirm(scene, buffers, rays, judged, own);
    return check;
}

std::size_t count_faults(const AnswerCheck& check) {
    return static_cast<std::size_t>(
        std::ranges::count_if(check.wrong, [](const WrongAnswer& each) { return each.is_fault; }));
}

std::string to_table(const AnswerCheck& check) {
    const std::size_t faults = count_faults(check);
    const auto text_of = [](std::size_t number) { return readable(static_cast<double>(number)); };
    const std::size_t slipped = check.wrong.size() - faults;
    std::string table =
        fmt::format("\nOf {} rays {} get a wrong answer{}.\n", text_of(check.rays), text_of(faults),
                    slipped == 0 ? "" : ", and " + text_of(slipped) + " slip through a tight box");
    table += fmt::format("  Judged by a loop over every triangle: {}a random sample of {}.\n",
                         check.wrong.empty()
                             ? ""
                             : text_of(std::min(check.wrong.size(), most_disputed_rays)) +
                                   " of these, and ",
                         text_of(check.judged));
    if (check.by_rounding > 0) {
        table += fmt::format("  {} more name another triangle that is as near, within rounding.\n",
                             text_of(check.by_rounding));
    }
    constexpr std::size_t most_told = 10;
    std::size_t told = 0;
    for (const WrongAnswer& each : check.wrong) {
        if (told++ == most_told) {
            table += "  ...\n";
            break;
        }
        table += fmt::format("  ray {}: {}; right is {}: {}\n", each.ray, name_of(each.given),
                             name_of(each.right), each.cause);
    }
    return table;
}

Numbers numbers_of(const AnswerCheck& check) {
    Numbers first = empty_list();
    for (const WrongAnswer& each : check.wrong) {
        if (first.values().size() < 10) {
            first.push_back({{"ray", each.ray},
                             {"given_triangle", each.given.triangle},
                             {"right_triangle", each.right.triangle},
                             {"cause", each.cause}});
        }
    }
    const std::size_t faults = count_faults(check);
    return {{"rays", check.rays},
            {"wrong", faults},
            {"slipped", check.wrong.size() - faults},
            {"by_rounding", check.by_rounding},
            {"judged_rays", check.judged},
            {"first_wrong", first}};
}

} // namespace raysteps
