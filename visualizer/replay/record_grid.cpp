#include "record_with.h"

namespace raysteps {

namespace {

// A cell is left by the plane that the ray crosses first, and the next one begins there.
template <class Mirror>
struct ExplainCell {
    static constexpr bool each_test_is_a_step = false;

    ExplainCell(Mirror& mirror, const typename Mirror::Ray& mirror_ray, const RecorderInput&)
        : ray(mirror_ray), t(mirror.part_in_grid(mirror_ray).start) {}

    bool knows(Mirror& mirror, int number) const {
        const glm::ivec3 cells = mirror.grid_cells;
        return number >= 0 && number < cells.x * cells.y * cells.z;
    }

    Step visit(Mirror& mirror, int number, const typename Mirror::Hit&) const {
        const glm::ivec3 cell = mirror.grid_cell_of(number);
        const typename Mirror::real3 leaves(mirror.leaving(ray, 0, cell.x),
                                            mirror.leaving(ray, 1, cell.y),
                                            mirror.leaving(ray, 2, cell.z));
        Step step;
        step.cell = number;
        step.axis = mirror.first_axis(leaves);
        step.face = 2 * step.axis + (mirror.goes_up(ray, step.axis) ? 1 : 0);
        step.entry = t;
        step.exit = leaves[step.axis];
        step.listed = mirror.grid_start(number + 1) - mirror.grid_start(number);
        return step;
    }

    void leave(const Step& step) { t = step.exit; }

    Ending ending(const RecordedWalk& walk) const {
        if (walk.steps.empty()) {
            return Ending::no_way_in;
        }
        if (ended_at_any_hit(walk)) {
            return Ending::found;
        }
        const Step& last = walk.steps.back();
        if (!(last.nearest.t < last.exit)) {
            return Ending::outside;
        }
        return walk.hit.triangle == no_triangle ? Ending::ray_is_over : Ending::hit;
    }

    typename Mirror::Ray ray;
    float t; // where the walk is
};

template <template <class, class> class Walk>
WalkRecorder make_grid(const RecorderInput& input) {
    using Mirror = Walk<float, mirror::Recorder>;
    return recorder_of<Mirror, ExplainCell<Mirror>>(input);
}

} // namespace

Recorders grid_recorders() {
#define WALK(name) {#name, make_grid<mirror::walks::name>},
    return {WALKS_IN_grid};
#undef WALK
}

} // namespace raysteps
