#include "hard_ray.h"

#include "mirror/walks.h"
#include "visualizer/replay/sentence.h"

#include <algorithm>
#include <optional>

namespace raysteps::view {

namespace {

// A case may have very many rays of very long walks: of those only the first are asked.
constexpr std::size_t most_tests = 20'000'000;
constexpr std::size_t most_recorded = 3'000'000; // steps and tests of all walks together

std::string answer_text(int triangle) {
    return triangle == no_triangle ? "no hit" : "triangle " + std::to_string(triangle);
}

// The hit that a walk would end with, did it not ask where the hit lies.
std::optional<Hit> first_hit_taken(const RecordedWalk& walk) {
    for (const Step& step : walk.steps) {
        for (const TriangleTest& test : tests_of(walk, step)) {
            if (test.best && step.cell != no_cell && step.face >= 0 && test.hit.t > step.exit) {
                return test.hit;
            }
        }
    }
    return std::nullopt;
}

std::optional<HardRay> breaks_first_hit(std::span<const Ray> rays, const WalkRecorder& recorder) {
    std::size_t recorded = 0;
    for (std::size_t i = 0; i < rays.size() && recorded < most_recorded; ++i) {
        const RecordedWalk walk = recorder.record(rays[i], Question::nearest);
        recorded += walk.steps.size() + walk.tests.size();
        const auto taken = first_hit_taken(walk);
        if (taken && taken->triangle != walk.hit.triangle) {
            return HardRay{i,
                           "a walk that takes the first hit it finds, beyond the cell, answers " +
                               answer_text(taken->triangle) + " instead of " +
                               answer_text(walk.hit.triangle)};
        }
    }
    return std::nullopt;
}

std::optional<HardRay> breaks_triangle_test(std::span<const Ray> rays,
                                            const mirror::SceneBuffers& scene,
                                            const WalkRecorder& recorder) {
    using Mirror = mirror::triangle_tests::moeller_trumbore<float>;
    auto mirror = mirror::mirror_of<Mirror>(scene);
    const std::size_t triangles = std::max<std::size_t>(scene.corners.size() / 3, 1);
    const std::size_t count = std::min(rays.size(), most_tests / triangles);
    std::size_t recorded = 0;
    for (std::size_t i = 0; i < count && recorded < most_recorded; ++i) {
        const RecordedWalk walk = recorder.record(rays[i], Question::nearest);
        recorded += walk.steps.size() + walk.tests.size();
        const int right = walk.hit.triangle;
        const int usual = mirror.closest_hit(mirror::to_mirror<Mirror>(rays[i])).triangle;
        if (right != usual) {
            return HardRay{i, "the test by Moeller and Trumbore answers " + answer_text(usual) +
                                  " instead of " + answer_text(right)};
        }
    }
    return std::nullopt;
}

} // namespace

HardRay choose_hard_ray(std::span<const Ray> rays, const mirror::SceneBuffers& scene,
                        const WalkRecorder& recorder) {
    if (const auto found = breaks_first_hit(rays, recorder)) {
        return *found;
    }
    if (const auto found = breaks_triangle_test(rays, scene, recorder)) {
        return *found;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (recorder.record(rays[i], Question::nearest).hit.triangle != no_triangle) {
            return {i, "one of the rays that are aimed at it"};
        }
    }
    return {0, "one of the rays that are aimed at it, and miss"};
}

} // namespace raysteps::view
