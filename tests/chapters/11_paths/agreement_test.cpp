#include "catch.h"
#include "path_pictures.h"

using namespace raysteps;

namespace {

struct TestedScene {
    std::string name;
    int side;
    int blocks;            // of the GPU
    int reference_samples; // per pixel
    double bias;           // that is found in 99.9 % of runs, as a part of the mean
};

PathChoice by_chance(const std::string& heuristic) {
    return {.random = "pcg", .heuristic = heuristic, .max_bounces = 8, .seed = 5};
}

} // namespace

TEST_CASE("paths agree with an independent recursion in double, scene by scene",
          "[11][agreement]") {
    const auto context = make_context(ContextKind::automatic);
    for (const TestedScene& tested :
         {TestedScene{"cornell_box", 24, 48, 768, 0.01}, TestedScene{"glass_box", 12, 24, 64, 0.05},
          TestedScene{"soft_light", 12, 24, 64, 0.05}}) {
        const Scene scene = load_scene(tested.name);
        const PathSums sums = follow_paths(scene, by_chance("power"), tested.side, tested.blocks);
        const MeasuredMean ours = measured_mean(sums);
        const MeasuredMean theirs =
            measured_mean(follow_reference_paths(scene, {.width = tested.side,
                                                         .height = tested.side,
                                                         .samples = tested.reference_samples,
                                                         .max_bounces = 8,
                                                         .seed = 5}),
                          sums.sees_lamp);
        CAPTURE(tested.name, ours.mean, ours.error, theirs.mean, theirs.error);
        CHECK(apart(ours, theirs) < alarm);
        CHECK(smallest_bias_found(ours, theirs) < tested.bias);
        CHECK(sums.broken_count == 0);
        // The same test does find so much bias.
        const MeasuredMean biased{ours.mean * (1.0 + 2.0 * tested.bias), ours.error};
        CHECK(apart(biased, theirs) > alarm);
    }
}
