#include "scene/scene.h"

namespace raysteps {

float transparency(const Material& material) {
    if (material.opacity < 1.0f) {
        return 1.0f - material.opacity;
    }
    const int model = material.illumination_model;
    return model == 4 || model == 6 || model == 7 || model == 9 ? 1.0f : 0.0f;
}

} // namespace raysteps
