#include "scene/sample_knot.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/torus_knot.h"

namespace raysteps {

Scene sample_knot(int size) {
    return add_mesh({}, torus_knot(size), matte("jade", {0.15f, 0.55f, 0.40f}));
}

} // namespace raysteps
