#include "record_with.h"
#include "recorders.h"

namespace raysteps {

namespace mirror {

template <class Real>
struct EveryTriangleRecorded {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/every_triangle.glsl"
#define OBSERVER_PART "visualizer/replay/recorder.inc"
#include "mirror/parts.inc"
};

} // namespace mirror

namespace {

using Mirror = mirror::EveryTriangleRecorded<float>;

struct ExplainTest {
    static constexpr bool each_test_is_a_step = true;

    ExplainTest(const Mirror&, const Mirror::Ray& mirror_ray, const RecorderInput&)
        : ray(mirror_ray) {}

    Step visit(const Mirror&, int, const Mirror::Hit&) const {
        Step step;
        step.outcome = Outcome::tested;
        step.listed = 1;
        step.entry = ray.t_min;
        step.exit = ray.t_max;
        return step;
    }

    void leave(const Step&) const {}

    Ending ending(const RecordedWalk& walk) const {
        if (walk.steps.empty()) {
            return Ending::no_way_in;
        }
        return ended_at_any_hit(walk) ? Ending::found : Ending::all_seen;
    }

    Mirror::Ray ray;
};

} // namespace

WalkRecorder record_every_triangle(const RecorderInput& input) {
    return recorder_of<Mirror, ExplainTest>(input);
}

} // namespace raysteps
