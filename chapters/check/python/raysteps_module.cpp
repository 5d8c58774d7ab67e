// The module `raysteps` of Python: arrays of NumPy in; faults, figures and hits out.
#include "basics/error.h"
#include "check/answers.h"
#include "check/inspection.h"
#include "check/why.h"
#include "mirror/trace_by_mirror.h"
#include "structure/bvh/build_bvh.h"
#include "structure/padding.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace py = pybind11;
using namespace raysteps;

namespace {

template <class Number>
using Array = py::array_t<Number, py::array::c_style | py::array::forcecast>;

template <class Number>
void check_shape(const Array<Number>& array, const std::string& name,
                 const std::vector<py::ssize_t>& last) {
    bool fits = array.ndim() == static_cast<py::ssize_t>(last.size()) + 1;
    std::string wanted = "(n";
    for (std::size_t i = 0; i < last.size(); ++i) {
        fits = fits && array.shape(static_cast<py::ssize_t>(i) + 1) == last[i];
        wanted += ", " + std::to_string(last[i]);
    }
    if (!fits) {
        throw py::value_error(name + ": the shape " + wanted + ") is needed.");
    }
}

Scene scene_of(const Array<float>& triangles) {
    check_shape(triangles, "triangles", {3, 3});
    Scene scene;
    scene.name = "arrays";
    scene.corners.resize(3 * static_cast<std::size_t>(triangles.shape(0)));
    std::memcpy(scene.corners.data(), triangles.data(), sizeof(glm::vec3) * scene.corners.size());
    const auto finite = [](const glm::vec3& point) {
        return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
    };
    if (!std::ranges::all_of(scene.corners, finite)) {
        throw py::value_error("triangles: a corner is not finite.");
    }
    scene.normals = scene.corners;
    scene.triangle_materials.assign(scene.corners.size() / 3, 0);
    scene.materials.emplace_back();
    return scene;
}

std::vector<Ray> rays_of(const Array<float>& rays) {
    check_shape(rays, "rays", {8});
    std::vector<Ray> all(static_cast<std::size_t>(rays.shape(0)));
    const float* number = rays.data();
    for (Ray& ray : all) {
        ray = {{number[0], number[1], number[2]},
               {number[3], number[4], number[5]},
               number[6],
               number[7]};
        number += 8;
    }
    return all;
}

// Nodes and triangles as arrays, which are checked for their shapes alone: what is wrong with the
// tree is for `check` to say.
BoxTree tree_of(const Array<float>& lower, const Array<float>& upper,
                const Array<std::int32_t>& children, const Array<std::int32_t>& first,
                const Array<std::int32_t>& count, const Array<std::int32_t>& order, bool splits) {
    check_shape(lower, "lower", {3});
    check_shape(upper, "upper", {3});
    check_shape(first, "first", {});
    check_shape(count, "count", {});
    check_shape(order, "order", {});
    const py::ssize_t nodes = lower.shape(0);
    const bool has_width =
        children.ndim() == 2 &&
        (children.shape(1) == 2 || children.shape(1) == 4 || children.shape(1) == 8);
    if (!has_width) {
        throw py::value_error("children: the shape (n, 2), (n, 4) or (n, 8) is needed.");
    }
    if (upper.shape(0) != nodes || children.shape(0) != nodes || first.shape(0) != nodes ||
        count.shape(0) != nodes) {
        throw py::value_error("lower, upper, children, first and count have a row for each node, "
                              "so their first sizes are the same.");
    }
    BoxTree tree;
    tree.width = static_cast<int>(children.shape(1));
    tree.splits = splits;
    tree.children.assign(children.data(), children.data() + children.size());
    tree.order.assign(order.data(), order.data() + order.size());
    for (py::ssize_t i = 0; i < nodes; ++i) {
        const float* const low = lower.data() + 3 * i;
        const float* const high = upper.data() + 3 * i;
        tree.nodes.push_back({{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}},
                              first.data()[i],
                              count.data()[i]});
    }
    return tree;
}

template <class Number, class Value>
Array<Number> column_of(const BoxTree& tree, std::vector<py::ssize_t> last, const Value& value) {
    last.insert(last.begin(), static_cast<py::ssize_t>(tree.nodes.size()));
    Array<Number> array(last);
    Number* place = array.mutable_data();
    for (const BvhNode& node : tree.nodes) {
        place = value(node, place);
    }
    return array;
}

Array<float> corners_of_boxes(const BoxTree& tree, glm::vec3 Box::*corner) {
    return column_of<float>(tree, {3}, [&](const BvhNode& node, float* place) {
        const glm::vec3& point = node.box.*corner;
        return std::copy_n(&point.x, 3, place);
    });
}

Array<std::int32_t> indices_of(const BoxTree& tree, std::int32_t BvhNode::*index) {
    return column_of<std::int32_t>(tree, {}, [&](const BvhNode& node, std::int32_t* place) {
        *place = node.*index;
        return place + 1;
    });
}

py::object object_of(const Numbers& numbers) {
    return std::visit(
        [](const auto& value) -> py::object {
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::monostate>) {
                return py::none();
            } else if constexpr (std::is_same_v<Value, Numbers::List>) {
                py::list list;
                for (const Numbers& each : value) {
                    list.append(object_of(each));
                }
                return list;
            } else if constexpr (std::is_same_v<Value, Numbers::Object>) {
                py::dict object;
                for (const auto& [name, each] : value) {
                    object[py::str(name)] = object_of(each);
                }
                return object;
            } else {
                return py::cast(value);
            }
        },
        numbers.value());
}

py::tuple arrays_of(const std::vector<Hit>& hits) {
    const auto count = static_cast<py::ssize_t>(hits.size());
    Array<float> t(count);
    Array<float> u(count);
    Array<float> v(count);
    Array<std::int32_t> triangle(count);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        t.mutable_data()[i] = hits[i].t;
        u.mutable_data()[i] = hits[i].u;
        v.mutable_data()[i] = hits[i].v;
        triangle.mutable_data()[i] = hits[i].triangle;
    }
    return py::make_tuple(t, u, v, triangle);
}

BoxTree build(const Array<float>& triangles) {
    return box_tree_of(build_bvh(scene_of(triangles).corners, {}));
}

py::object check(const BoxTree& tree, const Array<float>& triangles,
                 const std::optional<Array<float>>& rays) {
    const Scene scene = scene_of(triangles);
    Numbers found = numbers_of(inspect(tree, scene, {}, [](double) {}));
    if (rays) {
        found["answers"] = numbers_of(check_walks(tree, scene, rays_of(*rays)));
    }
    return object_of(found);
}

py::object judge_hits(const Array<float>& triangles, const Array<float>& rays,
                      const Array<float>& t, const Array<std::int32_t>& triangle) {
    check_shape(t, "t", {});
    check_shape(triangle, "triangle", {});
    if (t.shape(0) != triangle.shape(0)) {
        throw py::value_error("t and triangle have a value for each ray.");
    }
    std::vector<Hit> hits(static_cast<std::size_t>(t.shape(0)));
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits[i] = {t.data()[i], 0.0f, 0.0f, triangle.data()[i]};
    }
    return object_of(numbers_of(check_hits(hits, scene_of(triangles), rays_of(rays))));
}

py::tuple trace(const BoxTree& tree, const Array<float>& triangles, const Array<float>& rays) {
    const Scene scene = scene_of(triangles);
    return arrays_of(hits_through(tree, scene, rays_of(rays)));
}

std::string why(const BoxTree& tree, const Array<float>& triangles, const Array<float>& ray,
                std::int32_t triangle) {
    const Scene scene = scene_of(triangles);
    if (triangle < 0 || triangle >= triangle_count(scene)) {
        throw py::index_error("triangle: there are " + std::to_string(triangle_count(scene)) +
                              ", counted from 0.");
    }
    if (ray.ndim() != 1 || ray.size() != 8) {
        throw py::value_error("ray: the shape (8,) is needed.");
    }
    const std::vector<Ray> rays =
        rays_of(Array<float>({py::ssize_t{1}, py::ssize_t{8}}, ray.data()));
    return why_not(tree, scene.corners, rays.front(), triangle);
}

py::tuple read_boxes(const std::string& path, const Array<float>& triangles) {
    TreeFile file = read_tree_file(path);
    const std::string made_by = file.made_by;
    AnyTree tree = in_numbers_of(std::move(file), scene_of(triangles).corners);
    if (!std::holds_alternative<BoxTree>(tree)) {
        throw py::value_error(path + ": this is " + kind_of(tree) +
                              ", and only hierarchies of boxes are read here.");
    }
    return py::make_tuple(std::move(std::get<BoxTree>(tree)), made_by);
}

void write_boxes(const BoxTree& tree, const std::string& path, const std::string& made_by) {
    write_tree_file(path, {made_by, tree});
}

constexpr auto triangles_are = "triangles: float32 (n, 3, 3), the corners\n";

} // namespace

PYBIND11_MODULE(raysteps, module) {
    module.doc() = "Acceleration structures of anybody's, checked and walked.\n\n"
                   "Arrays that are not of the dtype given are converted; their shapes must be "
                   "right.";
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError);

    py::class_<BoxTree>(module, "Tree",
                        "A hierarchy of boxes. Node 0 is the root. Nothing is known of it to be "
                        "right: ask `check`.")
        .def(py::init(&tree_of), py::arg("lower"), py::arg("upper"), py::arg("children"),
             py::arg("first"), py::arg("count"), py::arg("order"), py::arg("splits") = false,
             "lower, upper: float32 (n, 3), the boxes of n nodes\n"
             "children: int32 (n, 2), (n, 4) or (n, 8), -1 where there is none; a leaf has none\n"
             "first, count: int32 (n,), of a leaf: its triangles are order[first:first + count]\n"
             "order: int32 (m,), triangle numbers from 0\n"
             "splits: whether a triangle may be in several leaves that cover it together")
        .def_property_readonly(
            "lower", [](const BoxTree& tree) { return corners_of_boxes(tree, &Box::lower); },
            "float32 (n, 3)")
        .def_property_readonly(
            "upper", [](const BoxTree& tree) { return corners_of_boxes(tree, &Box::upper); },
            "float32 (n, 3)")
        .def_property_readonly(
            "children",
            [](const BoxTree& tree) {
                return Array<std::int32_t>({static_cast<py::ssize_t>(tree.nodes.size()),
                                            static_cast<py::ssize_t>(tree.width)},
                                           tree.children.data());
            },
            "int32 (n, 2), (n, 4) or (n, 8)")
        .def_property_readonly(
            "first", [](const BoxTree& tree) { return indices_of(tree, &BvhNode::first); },
            "int32 (n,)")
        .def_property_readonly(
            "count", [](const BoxTree& tree) { return indices_of(tree, &BvhNode::count); },
            "int32 (n,)")
        .def_property_readonly(
            "order",
            [](const BoxTree& tree) {
                return Array<std::int32_t>(static_cast<py::ssize_t>(tree.order.size()),
                                           tree.order.data());
            },
            "int32 (m,)")
        .def_readonly("splits", &BoxTree::splits);

    module.def(
        "build", &build, py::arg("triangles"),
        (std::string("Our own tree, by the surface-area heuristic.\n\n") + triangles_are).c_str());
    module.def("check", &check, py::arg("tree"), py::arg("triangles"), py::arg("rays") = py::none(),
               (std::string("What is wrong with the tree: the dictionary that --json of `check` "
                            "writes, without its head.\n\n") +
                triangles_are +
                "rays: float32 (k, 8) or None: origin, direction, t_min, t_max. With them, which "
                "rays go wrong, under `answers`")
                   .c_str());
    module.def("trace", &trace, py::arg("tree"), py::arg("triangles"), py::arg("rays"),
               (std::string("The nearest hits through the tree, by the watertight test: t, u, v, "
                            "float32 (k,), and triangle, int32 (k,), -1 of a miss. Raises "
                            "InputError where no walk goes through the tree.\n\n") +
                triangles_are + "rays: float32 (k, 8)")
                   .c_str());
    module.def("judge", &judge_hits, py::arg("triangles"), py::arg("rays"), py::arg("t"),
               py::arg("triangle"),
               (std::string("Hits that were found elsewhere, judged: the dictionary `answers` of "
                            "`check`.\n\n") +
                triangles_are +
                "rays: float32 (k, 8)\nt: float32 (k,)\ntriangle: int32 (k,), -1 of a miss")
                   .c_str());
    module.def("why", &why, py::arg("tree"), py::arg("triangles"), py::arg("ray"),
               py::arg("triangle"),
               (std::string("Why a walk does not come to the triangle, in words.\n\n") +
                triangles_are + "ray: float32 (8,)")
                   .c_str());
    module.def("read", &read_boxes, py::arg("path"), py::arg("triangles"),
               (std::string("The tree of a tree file, in the numbers of these triangles, and what "
                            "made it, in words.\n\n") +
                triangles_are)
                   .c_str());
    module.def("write", &write_boxes, py::arg("tree"), py::arg("path"), py::arg("made_by") = "",
               "Writes a tree file (docs/tree_files.md); its numbers count the scene's triangles.");
}
