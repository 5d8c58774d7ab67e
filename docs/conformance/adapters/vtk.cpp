// VTK's locators: adapter_vtk MODE %t %r %h, where MODE is obb, bsp, cell or static
#include "segment.h"

#include <vtkCellArray.h>
#include <vtkCellLocator.h>
#include <vtkModifiedBSPTree.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

namespace {

vtkSmartPointer<vtkAbstractCellLocator> locator_of(const std::string& mode) {
    if (mode == "obb") {
        return vtkSmartPointer<vtkOBBTree>::New();
    }
    if (mode == "bsp") {
        return vtkSmartPointer<vtkModifiedBSPTree>::New();
    }
    if (mode == "cell") {
        return vtkSmartPointer<vtkCellLocator>::New();
    }
    return vtkSmartPointer<vtkStaticCellLocator>::New();
}

} // namespace

int main(int, char** argv) {
    const auto triangles = suite::read<suite::Triangle>(argv[2]);
    const auto rays = suite::read<suite::AimedRay>(argv[3]);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    for (const suite::Triangle& triangle : triangles) {
        vtkIdType ids[3];
        for (int i = 0; i < 3; ++i) {
            const float* corner = triangle.corners[i];
            ids[i] = points->InsertNextPoint(corner[0], corner[1], corner[2]);
        }
        cells->InsertNextCell(3, ids);
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    const auto locator = locator_of(argv[1]);
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    const suite::Segments segments(triangles);
    std::vector<suite::Answer> answers(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double first = rays[i].t_min;
        const double last = segments.end_of(rays[i]);
        const suite::Point from = suite::point_at(rays[i], first);
        const suite::Point to = suite::point_at(rays[i], last);
        double t = 0.0;
        double place[3];
        double weights[3];
        int part = 0;
        vtkIdType cell = -1;
        if (first <= last && locator->IntersectWithLine(from.data(), to.data(), 0.0, t, place,
                                                        weights, part, cell) != 0) {
            answers[i] = {static_cast<float>(first + t * (last - first)), -1.0f, -1.0f,
                          static_cast<std::int32_t>(cell)};
        }
    }
    suite::write(argv[4], answers);
}
