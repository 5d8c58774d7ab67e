#include "finding.h"

#include "basics/error.h"
#include "basics/text.h"
#include "keys.h"
#include "mirror/trace_by_mirror.h"
#include "mirror/walks.h"
#include "pointing.h"
#include "scene/view.h"
#include "structure/bvh/bvh_split.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace raysteps::view {

namespace {

// The next step, round from the state's, of which that is true; the same state where there is none.
State at_next(const State& state, const Stage& stage, const RecordedWalk& walk,
              const std::function<bool(const Step&)>& is_sought) {
    const std::size_t count = walk.steps.size();
    for (std::size_t more = 1; more <= count; ++more) {
        const std::size_t step = (step_in(walk, state) + more) % count;
        if (is_sought(walk.steps[step])) {
            return with_step(state, stage, static_cast<int>(step));
        }
    }
    return state;
}

bool has_cell(const Pane& pane, int cell) {
    return cell >= 0 && static_cast<std::size_t>(cell) < pane.cells.cells.size();
}

// Those that the cell lists.
std::span<const std::int32_t> listed_in(const PackedStructure& packed, const char* references,
                                        std::int32_t first, std::int32_t end) {
    return std::span(packed.integers.at(references))
        .subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
}

bool holds_triangle(std::span<const std::int32_t> triangles, std::int32_t triangle) {
    return std::find(triangles.begin(), triangles.end(), triangle) != triangles.end();
}

// Of a grid, a kd-tree or a hierarchy of boxes: whether a cell lists the triangle.
std::function<bool(int)> lists_triangle(const Pane& pane, std::int32_t triangle) {
    const PackedStructure& packed = pane.built.packed;
    if (pane.cells.kind == CellKind::grid) {
        return [&packed, triangle](int cell) {
            mirror::walks::grid<float> mirror{}; // a reference has bits of the mailbox too
            const auto place = static_cast<std::size_t>(cell);
            const std::vector<std::int32_t>& starts = packed.integers.at("grid_starts");
            const auto listed =
                listed_in(packed, "grid_references", starts[place], starts[place + 1]);
            return std::any_of(listed.begin(), listed.end(), [&](std::int32_t reference) {
                return mirror.grid_triangle(reference) == triangle;
            });
        };
    }
    if (pane.cells.kind == CellKind::kd_tree) {
        return [&pane, &packed, triangle](int cell) {
            const auto place = static_cast<std::size_t>(cell);
            const glm::ivec4& node = packed.integer_vectors.at("kd_nodes")[place];
            return pane.cells.cells[place].leaf &&
                   holds_triangle(listed_in(packed, "kd_references", node.y, node.z), triangle);
        };
    }
    return [tree = pane.tree ? *pane.tree : box_tree_of(pane.cells, packed), triangle](int cell) {
        const BvhNode& node = tree.nodes[static_cast<std::size_t>(cell)];
        const auto first = static_cast<std::size_t>(std::max(node.first, 0));
        const auto count = static_cast<std::size_t>(std::max(node.count, 0));
        return is_leaf(tree, static_cast<std::size_t>(cell)) &&
               first + count <= tree.order.size() &&
               holds_triangle(std::span(tree.order).subspan(first, count), triangle);
    };
}

Found found_cell(const Pane& pane, int cell) {
    const int triangles = pane.cells.cells[static_cast<std::size_t>(cell)].triangles;
    return {cell, cell_name(pane.cells, cell) + ", " + std::to_string(triangles) +
                      (triangles == 1 ? " triangle" : " triangles")};
}

Found find_number(const Pane& pane, int number) {
    return has_cell(pane, number) ? found_cell(pane, number)
                                  : Found{no_cell, "there is no such cell: they are 0 to " +
                                                       std::to_string(pane.cells.cells.size() - 1)};
}

Found find_triangle(const Stage& stage, const State& state, int triangle) {
    const Pane& pane = *stage.panes().front();
    if (triangle < 0 || triangle >= triangle_count(stage.scene())) {
        return {no_cell, "there is no such triangle: they are 0 to " +
                             std::to_string(triangle_count(stage.scene()) - 1)};
    }
    const auto lists = lists_triangle(pane, triangle);
    const int count = static_cast<int>(pane.cells.cells.size());
    for (int more = 1; more <= count; ++more) {
        const int cell = (std::max(state.selected, -1) + more) % count;
        if (lists(cell)) {
            return found_cell(pane, cell);
        }
    }
    return {no_cell, "no cell lists triangle " + std::to_string(triangle)};
}

Found find_point(const Pane& pane, const glm::vec3& point) {
    Found found{no_cell, "no cell is around that point"};
    double least = 0.0;
    for (std::size_t i = 0; i < pane.cells.cells.size(); ++i) {
        const Box& box = pane.cells.cells[i].box;
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            inside = inside && box.lower[axis] <= point[axis] && point[axis] <= box.upper[axis];
        }
        if (inside && (found.cell == no_cell || surface_area(box) <= least)) {
            found = found_cell(pane, static_cast<int>(i));
            least = surface_area(box);
        }
    }
    return found;
}

// Only that many rays at once, so that a difference near by is found at once.
constexpr int rows_at_once = 16;

std::vector<Hit> hits_of(const Stage& stage, const Pane& pane, std::span<const Ray> rays) {
    return mirror_walks().at(pane.structure)(stage.buffers(), pane.built.packed, rays);
}

bool differ(const Hit& one, const Hit& other) {
    return one.triangle != other.triangle || (one.triangle != no_triangle && one.t != other.t);
}

State at_pixel(const State& state, const glm::ivec2& pixel) {
    State next = state;
    next.pixel = pixel;
    next.ray.reset();
    next.path_ray = 0;
    next.step = last_step;
    next.why = no_triangle;
    next.filter = CellFilter::visited;
    return next;
}

} // namespace

State at_next_visit(const State& state, const Stage& stage) {
    const RecordedWalk* const walk = walk_in(*stage.panes().front(), state);
    if (!walk || state.selected < 0) {
        return state;
    }
    return at_next(state, stage, *walk,
                   [&](const Step& step) { return step.cell == state.selected; });
}

State at_next_test(const State& state, const Stage& stage) {
    const RecordedWalk* const walk = walk_in(*stage.panes().front(), state);
    const int triangle = !walk ? no_triangle : state.why >= 0 ? state.why : walk->hit.triangle;
    if (triangle == no_triangle) {
        return state;
    }
    return at_next(state, stage, *walk, [&](const Step& step) {
        const auto tests = tests_of(*walk, step);
        return std::any_of(tests.begin(), tests.end(),
                           [&](const TriangleTest& test) { return test.triangle == triangle; });
    });
}

State at_next_difference(const State& state, const Stage& stage) {
    const auto& panes = stage.panes();
    if (panes.size() < 2 || !state.steps.empty() || !panes[0]->refusal.empty() ||
        !panes[1]->refusal.empty()) {
        return state;
    }
    const glm::ivec2 size = state.picture;
    const std::vector<Ray> rays = pixel_rays(
        raysteps::view_of(stage.camera(), static_cast<double>(size.x) / size.y), size.x, size.y);
    const int count = size.x * size.y;
    const int start = state.pixel ? state.pixel->y * size.x + state.pixel->x + 1 : 0;
    const int at_once = rows_at_once * size.x;
    for (int done = 0; done < count; done += at_once) {
        std::vector<Ray> some;
        for (int i = done; i < std::min(done + at_once, count); ++i) {
            some.push_back(rays[static_cast<std::size_t>((start + i) % count)]);
        }
        const std::vector<Hit> first = hits_of(stage, *panes[0], some);
        const std::vector<Hit> second = hits_of(stage, *panes[1], some);
        for (std::size_t i = 0; i < some.size(); ++i) {
            if (differ(first[i], second[i])) {
                const int pixel = (start + done + static_cast<int>(i)) % count;
                return at_pixel(state, {pixel % size.x, pixel / size.x});
            }
        }
    }
    return state;
}

State with_cell_of_step(const State& state, const Stage& stage) {
    const RecordedWalk* const walk = walk_in(*stage.panes().front(), state);
    if (!walk || walk->steps.empty()) {
        return state;
    }
    const int cell = walk->steps[step_in(*walk, state)].cell;
    return cell == no_cell ? state : with_selected(state, stage, cell);
}

State with_parent(const State& state, const Stage& stage) {
    const Pane& pane = *stage.panes().front();
    if (!has_cell(pane, state.selected)) {
        return state;
    }
    const int parent = pane.cells.cells[static_cast<std::size_t>(state.selected)].parent;
    return parent == no_cell ? state : with_selected(state, stage, parent);
}

State with_child(const State& state, const Stage& stage) {
    const std::vector<Cell>& cells = stage.panes().front()->cells.cells;
    const auto child = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
        return state.selected >= 0 && cell.parent == state.selected;
    });
    return child == cells.end()
               ? state
               : with_selected(state, stage, static_cast<int>(child - cells.begin()));
}

State with_sibling(const State& state, const Stage& stage, int more) {
    const Pane& pane = *stage.panes().front();
    if (!has_cell(pane, state.selected)) {
        return state;
    }
    const int parent = pane.cells.cells[static_cast<std::size_t>(state.selected)].parent;
    std::vector<int> children;
    for (std::size_t i = 0; parent != no_cell && i < pane.cells.cells.size(); ++i) {
        if (pane.cells.cells[i].parent == parent) {
            children.push_back(static_cast<int>(i));
        }
    }
    const auto own = std::find(children.begin(), children.end(), state.selected);
    if (own == children.end()) {
        return state;
    }
    const int count = static_cast<int>(children.size());
    const int place = static_cast<int>(own - children.begin());
    return with_selected(state, stage,
                         children[static_cast<std::size_t>((place + more + count) % count)]);
}

Found find_cell(const Stage& stage, const State& state, const std::string& text) {
    const Pane& pane = *stage.panes().front();
    if (pane.cells.cells.empty()) {
        return {no_cell, "the loop over every triangle has no cells"};
    }
    if (text.starts_with('t')) {
        if (const auto triangle = parse_number<int>(text.substr(1))) {
            return find_triangle(stage, state, *triangle);
        }
    }
    if (const auto number = parse_number<int>(text)) {
        return find_number(pane, *number);
    }
    if (const auto numbers = parse_numbers(text); numbers && numbers->size() == 3) {
        glm::vec3 point;
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] =
                std::ldexp((*numbers)[static_cast<std::size_t>(axis)], state.scale_exponent);
        }
        return find_point(pane, point);
    }
    return {no_cell, "a number is a cell, t17 is a triangle, and 0.5,1,2 is a point"};
}

State with_found(const State& state, const Stage& stage, const std::string& text) {
    const Found found = find_cell(stage, state, text);
    if (found.cell == no_cell) {
        throw InputError("--find " + text + ": " + found.words + ".");
    }
    return with_selected(state, stage, found.cell);
}

} // namespace raysteps::view
