#include "scene/obj/load_obj.h"

#include "basics/error.h"
#include "basics/file.h"
#include "basics/text.h"
#include "scene/mesh.h"
#include "scene/obj/mtl.h"
#include "scene/obj/obj_checks.h"
#include "scene/obj/obj_file.h"
#include "scene/obj/polygon.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <map>
#include <new>
#include <span>
#include <sstream>
#include <streambuf>
#include <unordered_map>

namespace raysteps {

namespace {

// Gives tinyobjloader one checked statement at a time, so that its callbacks know their line.
class StatementBuffer : public std::streambuf {
public:
    explicit StatementBuffer(ObjReading& reading) : reading_(reading) {}

protected:
    int_type underflow() override {
        statement_ = reading_.next_statement();
        setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
        return statement_.empty() ? traits_type::eof() : traits_type::to_int_type(statement_[0]);
    }

private:
    ObjReading& reading_;
    std::string statement_;
};

ObjReading& reading_of(void* user_data) {
    return *static_cast<ObjReading*>(user_data);
}

void take_face(void* user_data, tinyobj::index_t* corners, int corner_count) {
    ObjReading& reading = reading_of(user_data);
    reading.begin_face();
    for (const tinyobj::index_t& corner :
         std::span(corners, static_cast<std::size_t>(corner_count)))
        reading.take_corner(corner.vertex_index, corner.texcoord_index, corner.normal_index);
}

tinyobj::callback_t callbacks() {
    tinyobj::callback_t callback;
    callback.texcoord_cb = [](void* reading, float x, float y, float) {
        reading_of(reading).take_texture_coordinate(x, y);
    };
    callback.normal_cb = [](void* reading, float x, float y, float z) {
        reading_of(reading).take_normal(x, y, z);
    };
    callback.usemtl_cb = [](void* reading, const char* name, int) {
        reading_of(reading).take_material(name);
    };
    callback.index_cb = take_face;
    return callback;
}

ObjFile read_obj(std::string_view text, const std::filesystem::path& path, Origin origin) {
    ObjReading reading(text, path);
    StatementBuffer buffer(reading);
    std::istream stream(&buffer);
    stream.exceptions(std::ios::badbit); // else the stream keeps an InputError of ours to itself
    tinyobj::LoadObjWithCallback(stream, callbacks(), &reading);
    return reading.finish(origin);
}

glm::vec3 to_color(const float (&color)[3]) {
    return {color[0], color[1], color[2]};
}

Material to_material(const tinyobj::material_t& source) {
    Material material;
    material.name = source.name;
    material.diffuse = to_color(source.diffuse);
    material.specular = to_color(source.specular);
    material.shininess = source.shininess;
    material.emission = to_color(source.emission);
    material.refractive_index = source.ior;
    material.opacity = source.dissolve;
    material.transmission = to_color(source.transmittance);
    material.illumination_model = source.illum;
    material.diffuse_map = source.diffuse_texname;
    material.cutout_map = source.alpha_texname;
    material.normal_map = source.normal_texname;
    material.emissive_map = source.emissive_texname;
    if (!material.emissive_map.empty()) { // what glows by a picture does not glow all over
        if (material.emission != glm::vec3(0.0f))
            material.emissive_factor = material.emission;
        material.emission = glm::vec3(0.0f);
    }
    return material;
}

// Versions of tinyobjloader disagree on where a name with spaces ends; the text is clear.
std::vector<std::string> names_in(const std::string& clean_mtl) {
    const std::string keyword = "newmtl ";
    std::istringstream lines(clean_mtl);
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(keyword))
            names.push_back(line.substr(keyword.size()));
    }
    return names;
}

std::vector<Material> read_clean_mtl(const std::string& text) {
    std::vector<tinyobj::material_t> sources;
    std::map<std::string, int> index_of_name;
    std::istringstream stream(text);
    std::string warning;
    std::string error;
    if (!text.empty()) // tinyobjloader makes a material of nothing
        tinyobj::LoadMtl(&index_of_name, &sources, &stream, &warning, &error);
    std::vector<Material> materials;
    materials.reserve(sources.size());
    for (const tinyobj::material_t& source : sources)
        materials.push_back(to_material(source));
    const std::vector<std::string> names = names_in(text);
    for (std::size_t i = 0; i < materials.size() && names.size() == materials.size(); ++i)
        materials[i].name = names[i];
    return materials;
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

ObjFile read_text(std::string_view text, const std::filesystem::path& path, Origin origin) {
    check_is_text(text, path);
    return read_obj(text, path, origin);
}

Scene scene_of(ObjFile file) {
    const std::filesystem::path path = file.path;
    std::vector<std::string> messages = file.findings.sentences(path);
    const MtlFiles mtl_files = read_mtl_files(file);
    append(messages, mtl_files.findings.sentences(path));

    std::vector<Material> materials;
    for (const MtlFile& mtl_file : mtl_files.files) {
        const ParsedMtl parsed = parse_mtl(mtl_file.text, mtl_file.path, folder_of(path));
        materials.insert(materials.end(), parsed.materials.begin(), parsed.materials.end());
        append(messages, parsed.messages);
    }
    Scene scene = make_scene(std::move(file), std::move(materials));
    append(messages, scene.messages);
    scene.messages = std::move(messages);
    return scene;
}

// Whatever the step throws leaves as a sentence that names the file.
template <class Step>
auto guarded(const std::filesystem::path& path, const Step& step) {
    try {
        return step();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw MachineError(path.string() + ": is too large for the memory of this machine. Close "
                                           "other programs, or load a smaller model.");
    } catch (const std::exception& failure) {
        throw InputError(path.string() + ": cannot be loaded (" + failure.what() +
                         "). Check the export.");
    }
}

} // namespace

Scene load_obj(const std::filesystem::path& path, Origin origin) {
    return guarded(path, [&] { // and the text is gone before there is a scene
        return scene_of(read_text(read_file(path, most_obj_bytes), path, origin));
    });
}

Scene parse_obj(std::string_view text, const std::filesystem::path& path, Origin origin) {
    return guarded(path, [&] { return scene_of(read_text(text, path, origin)); });
}

ParsedMtl parse_mtl(std::string_view text, const std::filesystem::path& path,
                    const std::filesystem::path& inside) {
    return guarded(path, [&] {
        check_is_text(text, path);
        const CleanMtl clean = clean_mtl(text);
        ParsedMtl parsed{read_clean_mtl(clean.text), clean.findings.sentences(path)};
        for (Material& material : parsed.materials) {
            for (std::string* map : {&material.diffuse_map, &material.cutout_map,
                                     &material.normal_map, &material.emissive_map}) {
                const MtlTexture texture = find_texture(*map, path, inside);
                *map = texture.path;
                if (!texture.message.empty())
                    parsed.messages.push_back(texture.message);
            }
        }
        return parsed;
    });
}

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

bool has_no_area(std::span<const glm::vec3> polygon, std::span<const PolygonTriangle> triangles) {
    return std::any_of(triangles.begin(), triangles.end(), [&](const PolygonTriangle& corners) {
        const auto& [a, b, c] = corners;
        return area_vector(polygon[a], polygon[b], polygon[c]) == glm::dvec3(0.0);
    });
}

class SceneMaker {
public:
    SceneMaker(ObjFile file, std::vector<Material> materials) : file_(std::move(file)) {
        material_of_name_ = find_materials(file_.material_names, materials);
        scene_.materials = std::move(materials);
        std::size_t triangles = 0; // at most
        for (const ObjFace& face : file_.faces)
            triangles += static_cast<std::size_t>(std::max(face.corner_count - 2, 0));
        scene_.corners.reserve(3 * triangles);
        scene_.texture_coordinates.reserve(file_.texture_coordinates.empty() ? 0 : 3 * triangles);
        scene_.corner_colors.reserve(file_.colors.empty() ? 0 : 3 * triangles);
        origins_.reserve(3 * triangles);
        scene_.triangle_materials.reserve(triangles);
        scene_.faces.reserve(triangles);
    }

    Scene make();

private:
    void add_face(const ObjFace& face);
    void begin_run(int object);
    void add_corner(std::size_t place, int smoothing_group);
    int material_of(const ObjFace& face);

    ObjFile file_;
    std::vector<int> material_of_name_;
    std::vector<CornerOrigin> origins_; // of each corner of the scene
    ObjFindings findings_;
    int object_ = not_given; // of the run of triangles
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
    // A polygon of n corners is n - 2 triangles to whoever does not look where they lie.
    for (std::size_t i = triangles.size() + 2; i < polygon.size(); ++i)
        scene_.left_out.push_back(triangle_count(scene_) +
                                  static_cast<int>(triangles.size() + scene_.left_out.size()));
    if (triangles.empty()) {
        findings_.note("A face with fewer than three different corners was dropped", face.line);
        return;
    }
    if (has_no_area(polygon, triangles))
        findings_.note("A face has a triangle whose corners lie on one line; it is kept, since it "
                       "may close a slit",
                       face.line);
    if (repeats_corner(corners))
        findings_.note("A face names a vertex twice in a row; it is drawn as if once", face.line);
    const int material = material_of(face);
    begin_run(face.object);
    for (const PolygonTriangle& triangle : triangles) {
        for (const int corner : triangle)
            add_corner(face.first_corner + static_cast<std::size_t>(corner), face.smoothing_group);
        scene_.triangle_materials.push_back(material);
        scene_.faces.push_back(face.number);
    }
}

void SceneMaker::begin_run(int object) {
    if (object == object_)
        return;
    object_ = object;
    const auto index = static_cast<std::size_t>(object);
    scene_.runs.push_back({triangle_count(scene_), 0, file_.objects[index],
                           file_.primitives.empty() ? not_given : file_.primitives[index]});
}

void SceneMaker::add_corner(std::size_t place, int smoothing_group) {
    const ObjCorner& corner = file_.corners[place];
    const int index = corner.texture_coordinate;
    scene_.corners.push_back(file_.positions[corner.position]);
    if (!file_.texture_coordinates.empty())
        scene_.texture_coordinates.push_back(index == not_given ? glm::vec2(0.0f)
                                                                : file_.texture_coordinates[index]);
    if (!file_.colors.empty())
        scene_.corner_colors.push_back(file_.colors[corner.position]);
    origins_.push_back({static_cast<std::uint32_t>(place), smoothing_group});
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

Scene SceneMaker::make() {
    for (const ObjFace& face : file_.faces)
        add_face(face);
    file_.faces = {}; // millions of triangles need the room for their normals
    scene_.name = file_.path.stem().string();
    scene_.origin = file_.origin;
    scene_.models.push_back({file_.path.string()});
    scene_.messages = findings_.sentences(file_.path, file_.counts);
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

Scene make_scene(ObjFile file, std::vector<Material> materials) {
    return SceneMaker(std::move(file), std::move(materials)).make();
}

} // namespace raysteps
