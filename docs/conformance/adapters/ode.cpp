// Open Dynamics Engine: adapter_ode %t %r %h
#include "segment.h"

#include <ode/ode.h>

int main(int, char** argv) {
    const auto triangles = suite::read<suite::Triangle>(argv[1]);
    const auto rays = suite::read<suite::AimedRay>(argv[2]);
    std::vector<dTriIndex> indices(3 * triangles.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i] = static_cast<dTriIndex>(i);
    }
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(data, triangles.data(), 12, static_cast<int>(indices.size()),
                                indices.data(), static_cast<int>(indices.size()),
                                3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    const dGeomID segment = dCreateRay(nullptr, 1.0);
    dGeomRaySetClosestHit(segment, 1);
    const suite::Segments segments(triangles);
    std::vector<suite::Answer> answers(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const float* along = rays[i].direction;
        const double length = std::hypot(static_cast<double>(along[0]), along[1], along[2]);
        const double last = segments.end_of(rays[i]);
        const suite::Point from = suite::point_at(rays[i], rays[i].t_min);
        if (!(last > rays[i].t_min)) {
            continue;
        }
        dGeomRaySetLength(segment, length * (last - rays[i].t_min));
        dGeomRaySet(segment, from[0], from[1], from[2], along[0], along[1], along[2]);
        dContactGeom contact;
        if (dCollide(segment, mesh, 1, &contact, sizeof contact) > 0) {
            answers[i].t = static_cast<float>(rays[i].t_min + contact.depth / length);
            answers[i].triangle = contact.side2;
        }
    }
    suite::write(argv[3], answers);
    dCloseODE();
}
