#include "scene/mesh.h"

namespace raysteps {

Mesh join(Mesh first, const Mesh& second) {
    first.corners.insert(first.corners.end(), second.corners.begin(), second.corners.end());
    first.normals.insert(first.normals.end(), second.normals.begin(), second.normals.end());
    return first;
}

Scene add_mesh(Scene scene, const Mesh& mesh, const Material& material) {
    const int material_index = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene.corners.insert(scene.corners.end(), mesh.corners.begin(), mesh.corners.end());
    scene.normals.insert(scene.normals.end(), mesh.normals.begin(), mesh.normals.end());
    scene.texture_coordinates.resize(scene.corners.size(), glm::vec2(0.0f));
    scene.triangle_materials.resize(scene.corners.size() / 3, material_index);
    return scene;
}

} // namespace raysteps
