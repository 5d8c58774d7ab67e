#include "sentence.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

namespace {

std::string interval_of(const Step& step) {
    return "t " + short_number(step.entry) + " to " + short_number(step.exit);
}

std::string face_name(int face) {
    return std::string(face % 2 == 0 ? "-" : "+") + "xyz"[face / 2];
}

std::string hit_text(const RecordedWalk& walk, const Step& step) {
    const auto tests = tests_of(walk, step);
    const auto last_best =
        std::find_if(tests.rbegin(), tests.rend(), [](const TriangleTest& t) { return t.best; });
    if (last_best != tests.rend()) {
        const bool beyond = step.cell != no_cell && last_best->hit.t > step.exit;
        return "hit triangle " + std::to_string(last_best->triangle) + " at t " +
               short_number(last_best->hit.t) + (beyond ? ", beyond the box: not final" : "");
    }
    const bool any = std::any_of(tests.begin(), tests.end(), [](const TriangleTest& t) {
        return t.hit.triangle != no_triangle;
    });
    return any ? "no nearer hit" : "no hit";
}

std::string tests_text(const RecordedWalk& walk, const Step& step) {
    const std::size_t tested = step.end_test - step.first_test;
    if (step.listed == 0) {
        return "no triangle there";
    }
    const auto left_out = static_cast<std::size_t>(step.listed) - tested;
    const bool cut_short = walk.ending == Ending::found && &step == &walk.steps.back();
    std::string text = count_of(tested, "triangle") + " tested";
    if (left_out > 0 && !cut_short) {
        const std::string why =
            walk.told_by.empty() ? " passed over (tested in the cell before)" : " left out";
        text += ", " + std::to_string(left_out) + why;
    }
    return tested == 0 ? text : text + ", " + hit_text(walk, step);
}

std::string side_text(const Step& step, const Ray& ray) {
    const float direction = ray.direction[step.axis];
    const std::string plane = std::string("the plane across ") + "xyz"[step.axis];
    if (direction == 0.0f) {
        return plane + " is never crossed";
    }
    const bool passed = step.plane_t <= step.entry;
    return plane + (passed ? " was crossed at t " : " comes at t ") + short_number(step.plane_t);
}

std::string body_of(const RecordedWalk& walk, const Step& step, bool kd_tree) {
    switch (step.outcome) {
    case Outcome::tested:
        return hit_text(walk, step);
    case Outcome::entered:
        return kd_tree ? "t " + short_number(step.entry) + ", " + side_text(step, walk.ray)
                       : interval_of(step) + ", box met";
    case Outcome::climbed:
        return "up to it, the ray leaves it at t " + short_number(step.exit);
    case Outcome::emptied:
        return interval_of(step) + ", no box of its children met";
    case Outcome::missed:
        return "box missed, left out";
    case Outcome::behind:
        return "box begins at t " + short_number(step.entry) + ", behind the hit at t " +
               short_number(step.nearest.t) + ", left out";
    case Outcome::touched:
        return "only touched at t " + short_number(step.exit) + ", left out";
    case Outcome::leaf:
        break;
    }
    return interval_of(step) + (step.face >= 0 ? ", leaves through " + face_name(step.face) : "") +
           ", " + tests_text(walk, step);
}

} // namespace

std::string short_number(double value) {
    if (value >= 3.4e38) {
        return "infinity";
    }
    return fmt::format("{:.4g}", value);
}

std::string count_of(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string ending_of(const RecordedWalk& walk) {
    const std::string hit =
        walk.hit.triangle == no_triangle
            ? "no hit"
            : "triangle " + std::to_string(walk.hit.triangle) + " at t " + short_number(walk.hit.t);
    switch (walk.ending) {
    case Ending::no_way_in:
        return "the ray passes by, and nothing is visited";
    case Ending::hit:
        return "no nearer hit can come: " + hit;
    case Ending::found:
        return "any hit will do: " + hit;
    case Ending::ray_is_over:
        return "the ray is over: " + hit;
    case Ending::outside:
        return "the ray has left the structure: " + hit;
    case Ending::told:
        return "the walk ends with " + hit;
    case Ending::cut:
        return "the walk was not recorded to its end: " + hit;
    case Ending::all_seen:
        break;
    }
    return "nothing is left to visit: " + hit;
}

std::string sentence_of(const StructureCells& structure, const RecordedWalk& walk,
                        std::size_t number) {
    const Step& step = walk.steps.at(number);
    const bool lacks_place = step.cell == no_cell && structure.kind != CellKind::none;
    const std::string place =
        lacks_place ? "place " + std::to_string(step.place) + " that the structure does not have"
        : step.cell == no_cell ? "triangle " + std::to_string(step.place)
                               : cell_name(structure, step.cell);
    std::string sentence = "step " + std::to_string(number + 1) + ": " + place + ", " +
                           body_of(walk, step, structure.kind == CellKind::kd_tree);
    const bool is_last = number + 1 == walk.steps.size();
    if (is_last) {
        return sentence + "; the end, " + ending_of(walk);
    }
    const int next = walk.steps[number + 1].cell;
    return next == no_cell ? sentence : sentence + ", on to " + cell_name(structure, next);
}

} // namespace raysteps
