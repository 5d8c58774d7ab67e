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

void check_agreement_of_paths(const TestedScene& tested) {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene(tested.name, 1.0f);
    const PathSums sums = follow_paths(scene, {.random = "pcg", .max_bounces = 8, .seed = 5},
                                       tested.side, tested.blocks);
    const MeasuredMean ours = measured_mean(sums);
    const MeasuredMean theirs =
        measured_mean(follow_reference_paths(scene, {.width = tested.side,
                                                     .height = tested.side,
                                                     .samples = tested.reference_samples,
                                                     .max_bounces = 8,
                                                     .seed = 5}),
                      sums.sees_lamp);
    CAPTURE(tested.name, ours.mean, ours.error, theirs.mean, theirs.error);
    CHECK(apart(ours, theirs) < alarm_at);
    CHECK(smallest_bias_found(ours, theirs) < tested.bias);
    CHECK(sums.broken_count == 0);
    // The same test does find so much bias.
    const MeasuredMean biased{ours.mean * (1.0 + 2.0 * tested.bias), ours.error};
    CHECK(apart(biased, theirs) > alarm_at);
}

} // namespace

TEST_CASE("paths agree with an independent recursion in double, scene by scene",
          "[11][agreement]") {
    check_agreement_of_paths({"cornell_box", 24, 48, 768, 0.02});
    check_agreement_of_paths({"glass_box", 12, 24, 64, 0.25});
    check_agreement_of_paths({"soft_light", 12, 24, 64, 0.02});
}

TEST_CASE("a bias of 1 % in the Cornell box is found in 99.9 % of runs", "[11][.][long]") {
    check_agreement_of_paths({"cornell_box", 24, 176, 2816, 0.01});
}
