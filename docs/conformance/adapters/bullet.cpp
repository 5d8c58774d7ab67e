// Bullet: adapter_bullet %t %r %h
#include "segment.h"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

namespace {

class Nearest : public btTriangleRaycastCallback {
public:
    using btTriangleRaycastCallback::btTriangleRaycastCallback;

    btScalar reportHit(const btVector3&, btScalar fraction, int, int triangle) override {
        found = triangle;
        return m_hitFraction = fraction;
    }

    int found = -1;
};

btVector3 vector_of(const suite::Point& point) {
    return {static_cast<btScalar>(point[0]), static_cast<btScalar>(point[1]),
            static_cast<btScalar>(point[2])};
}

} // namespace

int main(int, char** argv) {
    const auto triangles = suite::read<suite::Triangle>(argv[1]);
    const auto rays = suite::read<suite::AimedRay>(argv[2]);
    btTriangleMesh mesh(true, false);
    for (const suite::Triangle& triangle : triangles) {
        const auto& [a, b, c] = triangle.corners;
        mesh.addTriangle({a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]});
    }
    btBvhTriangleMeshShape shape(&mesh, false); // the tree of whole floats, not of quantized ones
    const suite::Segments segments(triangles);
    std::vector<suite::Answer> answers(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double first = rays[i].t_min;
        const double last = segments.end_of(rays[i]);
        const btVector3 from = vector_of(suite::point_at(rays[i], first));
        const btVector3 to = vector_of(suite::point_at(rays[i], last));
        Nearest nearest(from, to);
        shape.performRaycast(&nearest, from, to);
        if (nearest.found >= 0) {
            const double share = static_cast<double>(nearest.m_hitFraction);
            answers[i].t = static_cast<float>(first + share * (last - first));
            answers[i].triangle = nearest.found;
        }
    }
    suite::write(argv[3], answers);
}
