#include "shapes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <array>
#include <vector>

namespace raysteps::view {

namespace {

using IdPair = std::array<vtkIdType, 2>;
using IdQuad = std::array<vtkIdType, 4>;

// Corner i of a box is at the upper end of axis a if bit a of i is set.
constexpr std::array<IdPair, 12> edges{{{0, 1},
                                        {2, 3},
                                        {4, 5},
                                        {6, 7},
                                        {0, 2},
                                        {1, 3},
                                        {4, 6},
                                        {5, 7},
                                        {0, 4},
                                        {1, 5},
                                        {2, 6},
                                        {3, 7}}};
constexpr std::array<IdQuad, 6> faces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

glm::vec3 corner_of(const Box& box, int i) {
    return {(i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
            (i & 4) != 0 ? box.upper.z : box.lower.z};
}

vtkIdType add_point(vtkPoints& points, const glm::vec3& point) {
    return points.InsertNextPoint(static_cast<double>(point.x), static_cast<double>(point.y),
                                  static_cast<double>(point.z));
}

vtkIdType add_corners(vtkPoints& points, const Box& box) {
    const vtkIdType first = points.GetNumberOfPoints();
    for (int i = 0; i < 8; ++i) {
        add_point(points, corner_of(box, i));
    }
    return first;
}

vtkSmartPointer<vtkDoubleArray> values_array() {
    vtkNew<vtkDoubleArray> array;
    array->SetName("value");
    return array;
}

void add_values(vtkPolyData& shape, std::span<const double> values, int times) {
    if (values.empty()) {
        return;
    }
    const auto array = values_array();
    for (const double value : values) {
        for (int i = 0; i < times; ++i) {
            array->InsertNextValue(value);
        }
    }
    shape.GetCellData()->SetScalars(array);
}

} // namespace

Shape box_edges(std::span<const Box> boxes, std::span<const double> values) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (const Box& box : boxes) {
        const vtkIdType first = add_corners(*points, box);
        for (const IdPair& edge : edges) {
            const IdPair ids{first + edge[0], first + edge[1]};
            lines->InsertNextCell(2, ids.data());
        }
    }
    auto shape = Shape::New();
    shape->SetPoints(points);
    shape->SetLines(lines);
    add_values(*shape, values, static_cast<int>(edges.size()));
    return shape;
}

Shape dashed_box_edges(std::span<const Box> boxes) {
    constexpr int dashes = 9;
    std::vector<std::pair<glm::vec3, glm::vec3>> segments;
    for (const Box& box : boxes) {
        for (const IdPair& edge : edges) {
            const glm::vec3 start = corner_of(box, static_cast<int>(edge[0]));
            const glm::vec3 along = corner_of(box, static_cast<int>(edge[1])) - start;
            for (int i = 0; i < dashes; ++i) {
                const float length = 1.0f / (2.0f * dashes - 1.0f);
                const float from = 2.0f * static_cast<float>(i) * length;
                segments.emplace_back(start + from * along, start + (from + length) * along);
            }
        }
    }
    return line_segments(segments);
}

Shape box_faces(std::span<const Box> boxes, std::span<const double> values) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    for (const Box& box : boxes) {
        const vtkIdType first = add_corners(*points, box);
        for (const IdQuad& face : faces) {
            const IdQuad ids{first + face[0], first + face[1], first + face[2], first + face[3]};
            quads->InsertNextCell(4, ids.data());
        }
    }
    auto shape = Shape::New();
    shape->SetPoints(points);
    shape->SetPolys(quads);
    add_values(*shape, values, static_cast<int>(faces.size()));
    return shape;
}

Shape rectangles(std::span<const Rectangle> planes, std::span<const double> values) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    for (const Rectangle& plane : planes) {
        const IdQuad ids{add_point(*points, plane.corner),
                         add_point(*points, plane.corner + plane.side),
                         add_point(*points, plane.corner + plane.side + plane.other_side),
                         add_point(*points, plane.corner + plane.other_side)};
        quads->InsertNextCell(4, ids.data());
    }
    auto shape = Shape::New();
    shape->SetPoints(points);
    shape->SetPolys(quads);
    add_values(*shape, values, 1);
    return shape;
}

Shape triangles(std::span<const glm::vec3> corners) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> polygons;
    points->Allocate(static_cast<vtkIdType>(corners.size()));
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::array<vtkIdType, 3> ids{add_point(*points, corners[i]),
                                           add_point(*points, corners[i + 1]),
                                           add_point(*points, corners[i + 2])};
        polygons->InsertNextCell(3, ids.data());
    }
    auto shape = Shape::New();
    shape->SetPoints(points);
    shape->SetPolys(polygons);
    return shape;
}

Shape line_segments(std::span<const std::pair<glm::vec3, glm::vec3>> segments) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (const auto& [start, end] : segments) {
        const IdPair ids{add_point(*points, start), add_point(*points, end)};
        lines->InsertNextCell(2, ids.data());
    }
    auto shape = Shape::New();
    shape->SetPoints(points);
    shape->SetLines(lines);
    return shape;
}

} // namespace raysteps::view
