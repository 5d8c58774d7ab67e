#include "shader_line.h"

#include "basics/error.h"

#include <filesystem>
#include <fstream>

namespace raysteps {

namespace {

// every_triangle
const LineMarker loop_nearer{"structure/every_triangle.glsl", "if (is_nearer(hit, nearest)) {"};
const LineMarker loop_found{"structure/every_triangle.glsl", "found = hit.t <= near_enough;"};

// Grids.
const LineMarker grid_leaves{"structure/grid/grid.glsl", "int axis = first_axis(leaves);"};
const LineMarker grid_hit{"structure/grid/grid.glsl", "ended = nearest.t < leaves[axis] ||"};
const LineMarker grid_outside{"structure/grid/grid.glsl", "ended = ended || i < 0 ||"};
const LineMarker grid_found{"structure/grid/grid.glsl", "ended = hit.t <= near_enough;"};

// kd-trees.
const LineMarker kd_side{"structure/kd_tree/kd_descent.glsl", "taken.child = t_split <= t ?"};
const LineMarker kd_along{"structure/kd_tree/kd_descent.glsl", "taken.child = ray.origin[node.axis] <="};
const LineMarker kd_ended{"structure/kd_tree/kd_descent.glsl", "visit.walk.ended = nearest.t < leaf.exit ||"};
const LineMarker kd_found{"structure/kd_tree/kd_descent.glsl", "found = hit.t <= near_enough;"};
const LineMarker kd_climbs{"structure/kd_tree/kd_backtrack.glsl", "while (up.exit <= t &&"};
const LineMarker kd_touches{"structure/kd_tree/kd_ropes.glsl", "bool only_touched = leaf.exit <= t &&"};

// Bounding volume hierarchies.
const LineMarker bvh_nearer{"structure/bvh/bvh_leaf.glsl", "if (is_nearer(hit, leaf.nearest)) {"};
const LineMarker bvh_found{"structure/bvh/bvh_leaf.glsl", "leaf.found = hit.t <= near_enough;"};
const LineMarker box_plain{"structure/bvh/box_plain.glsl", "return span.entry <= span.exit;"};
const LineMarker box_padded{"structure/bvh/box_padded.glsl", "return span.entry <= exit;"};

LineMarker bvh_met(const std::string& file) {
    return {file, "bool met = meets_bvh_node(for_boxes, here, nearest.t);"};
}

struct BvhText {
    LineMarker met;
    LineMarker entered;
};

BvhText bvh_text(const std::string& structure) {
    if (structure == "bvh_parent") {
        return {bvh_met("structure/bvh/bvh_parent.glsl"),
                {"structure/bvh/bvh_parent.glsl", "node = inside ? bvh_children("}};
    }
    if (structure == "bvh_stack") {
        return {bvh_met("structure/bvh/bvh_stack.glsl"),
                {"structure/bvh/bvh_stack.glsl", "node = children.near;"}};
    }
    return {bvh_met("structure/bvh/bvh_skip.glsl"),
            {"structure/bvh/bvh_skip.glsl", "node = met && !is_bvh_leaf(here) ?"}};
}

LineMarker grid_marker(const RecordedWalk& walk, bool is_last) {
    if (!is_last) {
        return grid_leaves;
    }
    if (walk.ending == Ending::found) {
        return grid_found;
    }
    return walk.ending == Ending::outside ? grid_outside : grid_hit;
}

LineMarker kd_marker(const RecordedWalk& walk, const Step& step, bool is_last) {
    switch (step.outcome) {
    case Outcome::climbed:
        return kd_climbs;
    case Outcome::touched:
        return kd_touches;
    case Outcome::entered:
        return walk.ray.direction[step.axis] == 0.0f ? kd_along : kd_side;
    default:
        return is_last && walk.ending == Ending::found ? kd_found : kd_ended;
    }
}

LineMarker bvh_marker(const RecordedWalk& walk, const Step& step, bool is_last) {
    switch (step.outcome) {
    case Outcome::missed:
        return walk.structure == "bvh_skip_padded" ? box_padded : box_plain;
    case Outcome::behind:
        return bvh_text(walk.structure).met;
    case Outcome::entered:
        return bvh_text(walk.structure).entered;
    default:
        return is_last && walk.ending == Ending::found ? bvh_found : bvh_nearer;
    }
}

LineMarker marker_of(const RecordedWalk& walk, std::size_t number) {
    const Step& step = walk.steps.at(number);
    const bool is_last = number + 1 == walk.steps.size();
    if (walk.structure.starts_with("grid")) {
        return grid_marker(walk, is_last);
    }
    if (walk.structure.starts_with("kd")) {
        return kd_marker(walk, step, is_last);
    }
    if (walk.structure.starts_with("bvh")) {
        return bvh_marker(walk, step, is_last);
    }
    return is_last && walk.ending == Ending::found ? loop_found : loop_nearer;
}

} // namespace

ShaderLine find_line(const LineMarker& marker) {
    std::ifstream file(std::filesystem::path(RAYSTEPS_SHADER_DIR) / marker.file);
    ShaderLine found;
    int number = 0;
    int times = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.find(marker.words) != std::string::npos) {
            ++times;
            found = {marker.file, number, line.substr(line.find_first_not_of(' '))};
        }
    }
    if (times != 1) {
        throw MachineError("shaders/" + marker.file + ": the line with `" + marker.words +
                           "` stands there " + std::to_string(times) +
                           " times, and is shown where it stands once. Restore the file, or name "
                           "its line in visualizer/replay/shader_line.cpp.");
    }
    return found;
}

ShaderLine deciding_line(const RecordedWalk& walk, std::size_t step) {
    return find_line(marker_of(walk, step));
}

std::vector<LineMarker> all_markers() {
    std::vector<LineMarker> markers{loop_nearer,  loop_found, grid_leaves, grid_hit,
                                    grid_outside, grid_found, kd_side,     kd_along,
                                    kd_ended,     kd_found,   kd_climbs,   kd_touches,
                                    bvh_nearer,   bvh_found,  box_plain,   box_padded};
    for (const std::string structure : {"bvh_skip", "bvh_parent", "bvh_stack"}) {
        const BvhText text = bvh_text(structure);
        markers.push_back(text.met);
        markers.push_back(text.entered);
    }
    return markers;
}

} // namespace raysteps
