// CGAL's AABB tree: adapter_cgal MODE %t %r %h, where MODE is a kernel: epick, epeck or double
#include "suite_files.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>

namespace {

double longest(const float* direction) {
    return static_cast<double>(
        std::max({std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])}));
}

template <class Kernel>
std::vector<suite::Answer> trace(const std::vector<suite::Triangle>& triangles,
                                 const std::vector<suite::AimedRay>& rays) {
    using Point = typename Kernel::Point_3;
    using List = std::vector<typename Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, typename List::iterator>;
    List list;
    for (const suite::Triangle& triangle : triangles) {
        Point points[3];
        for (int i = 0; i < 3; ++i) {
            const float* corner = triangle.corners[i];
            points[i] = Point(corner[0], corner[1], corner[2]);
        }
        list.emplace_back(points[0], points[1], points[2]);
    }
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(list.begin(), list.end());
    std::vector<suite::Answer> answers(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const suite::AimedRay& ray = rays[i];
        if (!std::isnormal(longest(ray.direction))) {
            continue;
        }
        // A ray is two points for CGAL: the second is as far from the first as the scene is large.
        const double scale = std::ldexp(1.0, -std::ilogb(longest(ray.direction)));
        const typename Kernel::Vector_3 along(scale * ray.direction[0], scale * ray.direction[1],
                                              scale * ray.direction[2]);
        const Point origin(ray.origin[0], ray.origin[1], ray.origin[2]);
        const typename Kernel::Ray_3 half_line(
            origin + typename Kernel::FT(ray.t_min / scale) * along, along);
        const auto hit = tree.first_intersection(half_line);
        if (!hit) {
            continue;
        }
        const Point* point = boost::get<Point>(&hit->first);
        const auto* segment = boost::get<typename Kernel::Segment_3>(&hit->first);
        Point place = point != nullptr ? *point : segment->source();
        if (segment != nullptr && (segment->target() - origin) * along < (place - origin) * along) {
            place = segment->target();
        }
        const double far =
            CGAL::to_double((place - origin) * along) / CGAL::to_double(along * along);
        const double t = std::max(scale * far, static_cast<double>(ray.t_min));
        if (t <= ray.t_max) {
            answers[i].t = static_cast<float>(t);
            answers[i].triangle = static_cast<std::int32_t>(hit->second - list.begin());
        }
    }
    return answers;
}

} // namespace

int main(int, char** argv) {
    const std::string mode = argv[1];
    const auto triangles = suite::read<suite::Triangle>(argv[2]);
    const auto rays = suite::read<suite::AimedRay>(argv[3]);
    using Double = CGAL::Simple_cartesian<double>;
    using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    suite::write(argv[4], mode == "epeck"   ? trace<Exact>(triangles, rays)
                          : mode == "epick" ? trace<Inexact>(triangles, rays)
                                            : trace<Double>(triangles, rays));
}
