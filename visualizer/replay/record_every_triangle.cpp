#include "record_with.h"

namespace raysteps {

namespace {

template <class Mirror>
struct ExplainTest {
    static constexpr bool each_test_is_a_step = true;

    ExplainTest(const Mirror&, const typename Mirror::Ray& mirror_ray, const RecorderInput&)
        : ray(mirror_ray) {}

    bool knows(const Mirror&, int) const { return true; }

    Step visit(const Mirror&, int, const typename Mirror::Hit&) const {
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

    typename Mirror::Ray ray;
};

template <template <class, class> class Walk>
WalkRecorder make_every_triangle(const RecorderInput& input) {
    using Mirror = Walk<float, mirror::Recorder>;
    return recorder_of<Mirror, ExplainTest<Mirror>>(input);
}

} // namespace

Recorders loop_recorders() {
#define WALK(name) {#name, make_every_triangle<mirror::walks::name>},
    return {WALKS_IN_structure};
#undef WALK
}

} // namespace raysteps
