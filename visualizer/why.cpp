#include "why.h"

#include "mirror/left_out.h"
#include "mirror/walks.h"

#include <cmath>

namespace raysteps::view {

namespace {

using Watertight = mirror::triangle_tests::watertight<float>;

Hit test_alone(const Stage& stage, const Ray& ray, int triangle) {
    auto mirror = mirror::mirror_of<Watertight>(stage.buffers());
    const auto prepared = mirror.prepare_ray(mirror::to_mirror<Watertight>(ray));
    return mirror::from_mirror(mirror.intersect_triangle(
        prepared, mirror.triangle_corner(triangle, 0), mirror.triangle_corner(triangle, 1),
        mirror.triangle_corner(triangle, 2), triangle));
}

} // namespace

Hit hit_by_loop(const Stage& stage, const Ray& ray) {
    auto mirror = mirror::mirror_of<Watertight>(stage.buffers());
    return mirror::from_mirror(mirror.closest_hit(mirror::to_mirror<Watertight>(ray)));
}

std::optional<Why> why_of(const Stage& stage, const State& state) {
    const Pane& pane = *stage.panes().front();
    const RecordedWalk* const walk = walk_in(pane, state);
    if (state.why < 0 || !walk) {
        return std::nullopt;
    }
    const Ray& ray = walk->ray;
    const Hit hit = test_alone(stage, ray, state.why);
    const bool meets = hit.triangle != no_triangle;
    const std::string name = "triangle " + std::to_string(state.why);
    Why why;
    why.lines.push_back(meets ? "By the watertight test the ray meets " + name + " at t " +
                                    std::to_string(hit.t) + "."
                              : "By the watertight test the ray does not meet " + name + ".");
    const std::vector<glm::vec3>& corners = stage.scene().corners;
    const auto first = corners.begin() + 3 * static_cast<std::ptrdiff_t>(state.why);
    why.corners.assign(first, first + 3);
    if (pane.cells.kind != CellKind::bvh || !walk->told_by.empty()) {
        why.lines.push_back("Which box leaves it out is told of our walks through hierarchies of "
                            "boxes.");
        return why;
    }
    const BoxTree tree = pane.tree ? *pane.tree : box_tree_of(pane.cells, pane.built.packed);
    const SoughtTriangle sought{state.why, meets ? std::nextafter(hit.t, ray.t_max) : ray.t_max,
                                meets};
    const LeftOut out =
        left_out(tree, paths_of(tree, corners.size() / 3), corners, ray, sought.t_max, state.why);
    for (const std::string& line : left_out_in_words(out, tree, ray, sought)) {
        why.lines.push_back(line);
    }
    if (out.node != no_child) {
        why.box = tree.nodes[static_cast<std::size_t>(out.node)].box;
    }
    return why;
}

} // namespace raysteps::view
