#include "scene/obj_scene.h"

#include "scene/obj_normals.h"
#include "scene/polygon_triangles.h"

#include <unordered_map>

namespace raysteps {

namespace {

// For each name that the faces use, the first material of that name, or not_given.
std::vector<int> find_materials(const std::vector<std::string>& names,
                                const std::vector<Material>& materials) {
    std::unordered_map<std::string_view, int> index_of_name;
    for (std::size_t i = 0; i < materials.size(); ++i)
        index_of_name.try_emplace(materials[i].name, static_cast<int>(i));
    std::vector<int> found;
    for (const std::string& name : names) {
        const auto entry = index_of_name.find(name);
        found.push_back(entry == index_of_name.end() ? not_given : entry->second);
    }
    return found;
}

// The default material comes last, and only where a triangle needs it.
void give_default_material(Scene& scene) {
    const auto next = static_cast<int>(scene.materials.size());
    bool is_needed = scene.materials.empty();
    for (int& material : scene.triangle_materials) {
        is_needed = is_needed || material == not_given;
        material = material == not_given ? next : material;
    }
    if (is_needed)
        scene.materials.emplace_back();
}

bool repeats_corner(std::span<const ObjCorner> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i].position == corners[(i + 1) % corners.size()].position)
            return true;
    return false;
}

class SceneMaker {
public:
    SceneMaker(const ObjFile& file, std::vector<Material> materials) : file_(file) {
        material_of_name_ = find_materials(file.material_names, materials);
        scene_.materials = std::move(materials);
    }

    void add_face(const ObjFace& face);
    Scene finish();

private:
    void add_corner(const ObjCorner& corner, int smoothing_group);
    int material_of(const ObjFace& face);

    const ObjFile& file_;
    std::vector<int> material_of_name_;
    std::vector<CornerOrigin> origins_; // of each corner of the scene
    Findings findings_;
    Scene scene_;
};

void SceneMaker::add_face(const ObjFace& face) {
    const std::span corners(file_.corners.data() + face.first_corner,
                            static_cast<std::size_t>(face.corner_count));
    std::vector<glm::vec3> polygon;
    polygon.reserve(corners.size());
    for (const ObjCorner& corner : corners)
        polygon.push_back(file_.positions[corner.position]);

    const std::vector<PolygonTriangle> triangles = triangulate_polygon(polygon);
    if (triangles.empty()) {
        findings_.note("A face without area was dropped", face.line);
        return;
    }
    if (repeats_corner(corners))
        findings_.note("A face names a vertex twice in a row; it is drawn as if once", face.line);
    const int material = material_of(face);
    for (const PolygonTriangle& triangle : triangles) {
        for (const int corner : triangle)
            add_corner(corners[corner], face.smoothing_group);
        scene_.triangle_materials.push_back(material);
    }
}

void SceneMaker::add_corner(const ObjCorner& corner, int smoothing_group) {
    const int place = corner.texture_coordinate;
    scene_.corners.push_back(file_.positions[corner.position]);
    scene_.texture_coordinates.push_back(place == not_given ? glm::vec2(0.0f)
                                                            : file_.texture_coordinates[place]);
    origins_.push_back({corner, smoothing_group});
}

int SceneMaker::material_of(const ObjFace& face) {
    if (face.material_name == not_given)
        return not_given;
    const int material = material_of_name_[face.material_name];
    if (material == not_given)
        findings_.note("Material " + in_quotes(file_.material_names[face.material_name]) +
                           " is in no MTL file that was read, so a default is used",
                       face.line);
    return material;
}

Scene SceneMaker::finish() {
    scene_.name = file_.path.stem().string();
    scene_.models.push_back({file_.path.string()});
    scene_.messages = findings_.sentences(file_.path);
    ObjNormals normals = make_normals(file_, scene_.corners, origins_);
    scene_.normals = std::move(normals.normals);
    scene_.messages.push_back(triangle_count(scene_) > 0
                                  ? normals.message
                                  : file_.path.string() + ": It holds no face that can be "
                                                          "drawn, so the scene is empty.");
    give_default_material(scene_);
    return std::move(scene_);
}

} // namespace

Scene make_scene(const ObjFile& file, std::vector<Material> materials) {
    SceneMaker maker(file, std::move(materials));
    for (const ObjFace& face : file.faces)
        maker.add_face(face);
    return maker.finish();
}

} // namespace raysteps
