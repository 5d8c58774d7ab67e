#include "scene/sample_compact.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

namespace raysteps {

Scene sample_compact(int size) {
    return add_mesh({}, sphere(glm::vec3(0.0f), 1.0f, size), matte("clay", {0.70f, 0.30f, 0.20f}));
}

} // namespace raysteps
