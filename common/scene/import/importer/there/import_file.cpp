#include "scene/import/importer/import_file.h"

#include "basics/error.h"

#include <assimp/GltfMaterial.h>
#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace raysteps {

namespace {

constexpr std::size_t most_lights = 16;

glm::dvec3 to_glm(const aiVector3D& vector) {
    return {vector.x, vector.y, vector.z};
}

glm::vec3 to_glm(const aiColor3D& color) {
    return {color.r, color.g, color.b};
}

struct NodePlace {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};
};

NodePlace operator*(const NodePlace& outer, const aiMatrix4x4& m) {
    const glm::dmat3 linear{{m.a1, m.b1, m.c1}, {m.a2, m.b2, m.c2}, {m.a3, m.b3, m.c3}};
    return {outer.linear * linear, outer.linear * glm::dvec3(m.a4, m.b4, m.c4) + outer.translation};
}

glm::dvec3 applied(const NodePlace& transform, const glm::dvec3& point) {
    return transform.linear * point + transform.translation;
}

// The cofactors turn normals, up to their length and a sign.
glm::dmat3 normal_matrix(const glm::dmat3& linear) {
    const glm::dmat3 cofactors{glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1])};
    return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
}

bool is_gltf(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return ending == ".gltf" || ending == ".glb" || ending == ".GLTF" || ending == ".GLB";
}

class Importing {
public:
    Importing(const aiScene& scene, const std::string& path)
        : scene_(scene), file_name_(std::filesystem::path(path).filename().string()),
          is_gltf_(is_gltf(path)) {}

    MeshFile mesh();

private:
    void add_pictures();
    void add_material(const aiMaterial& source);
    void add_nodes(const aiNode& node, const NodePlace& outer);
    void add_mesh(const aiMesh& source, const NodePlace& place, const std::string& object,
                  int primitive);
    void add_faces(const aiMesh& source, std::uint32_t first_vertex, bool mirrors);
    double vertical_angle(const aiCamera& camera) const;
    void add_cameras();
    void add_lights();
    void count_textures(const aiMaterial& source);
    void note(const std::string& what) { ++not_shown_[what]; }
    std::string picture_name(const aiString& path) const;

    const aiScene& scene_;
    std::string file_name_;
    bool is_gltf_;
    MeshFile mesh_;
    std::map<std::string, int> not_shown_; // what, and of how many
    std::map<std::string, NodePlace> place_of_node_;
};

// Assimp calls pictures in the file *0, *1 and so on.
std::string Importing::picture_name(const aiString& path) const {
    const std::string name = path.C_Str();
    return scene_.GetEmbeddedTexture(path.C_Str()) != nullptr ? file_name_ + ":" + name : name;
}

// An uncompressed TGA file with opacity, as the format was published by Truevision in 1989.
std::string tga_of(const aiTexture& texture) {
    std::string bytes(18, '\0');
    bytes[2] = 2; // true colour
    bytes[12] = static_cast<char>(texture.mWidth & 255u);
    bytes[13] = static_cast<char>(texture.mWidth >> 8u);
    bytes[14] = static_cast<char>(texture.mHeight & 255u);
    bytes[15] = static_cast<char>(texture.mHeight >> 8u);
    bytes[16] = 32;
    bytes[17] = 0x28; // eight bits of opacity, the top row first
    for (unsigned i = 0; i < texture.mWidth * texture.mHeight; ++i) {
        const aiTexel& texel = texture.pcData[i];
        for (const unsigned char value : {texel.b, texel.g, texel.r, texel.a}) {
            bytes += static_cast<char>(value);
        }
    }
    return bytes;
}

void Importing::add_pictures() {
    for (unsigned i = 0; i < scene_.mNumTextures; ++i) {
        const aiTexture& texture = *scene_.mTextures[i];
        const std::string bytes =
            texture.mHeight == 0
                ? std::string(reinterpret_cast<const char*>(texture.pcData), texture.mWidth)
                : tga_of(texture);
        mesh_.pictures.push_back({file_name_ + ":*" + std::to_string(i), bytes});
        if (texture.mFilename.length > 0) { // by which materials may name it, too
            mesh_.pictures.push_back({file_name_ + ":" + texture.mFilename.C_Str(), bytes});
        }
    }
}

struct NotShown {
    aiTextureType type;
    const char* name;
};

constexpr std::array<NotShown, 9> textures_not_shown{{
    {aiTextureType_HEIGHT, "bump maps"},
    {aiTextureType_SPECULAR, "specular pictures"},
    {aiTextureType_SHININESS, "shininess pictures"},
    {aiTextureType_METALNESS, "metalness pictures"},
    {aiTextureType_DIFFUSE_ROUGHNESS, "roughness pictures"},
    {aiTextureType_DISPLACEMENT, "displacement pictures"},
    {aiTextureType_REFLECTION, "reflection pictures"},
    {aiTextureType_TRANSMISSION, "transmission pictures"},
    {aiTextureType_CLEARCOAT, "clear coats"},
}};

void Importing::count_textures(const aiMaterial& source) {
    for (const NotShown& kind : textures_not_shown) {
        if (source.GetTextureCount(kind.type) > 0) {
            note(kind.name);
        }
    }
}

void Importing::add_material(const aiMaterial& source) {
    Material material;
    material.name = source.GetName().C_Str();
    if (material.name.empty()) {
        material.name = "material " + std::to_string(mesh_.materials.size());
    }
    aiColor4D color(0.8f, 0.8f, 0.8f, 1.0f);
    if (source.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS) {
        source.Get(AI_MATKEY_COLOR_DIFFUSE, color);
    }
    material.diffuse = {color.r, color.g, color.b};

    aiString picture;
    if (source.GetTexture(aiTextureType_BASE_COLOR, 0, &picture) == aiReturn_SUCCESS ||
        source.GetTexture(aiTextureType_DIFFUSE, 0, &picture) == aiReturn_SUCCESS) {
        material.diffuse_map = picture_name(picture);
    }

    float factor = 0.0f;
    const bool is_physical = source.Get(AI_MATKEY_METALLIC_FACTOR, factor) == aiReturn_SUCCESS;
    if (is_physical && factor > 0.0f) {
        note("metallic factors");
    }
    aiColor3D specular(0.0f, 0.0f, 0.0f);
    float strength = 1.0f;
    if (!is_physical && source.Get(AI_MATKEY_COLOR_SPECULAR, specular) == aiReturn_SUCCESS &&
        source.Get(AI_MATKEY_SHININESS, material.shininess) == aiReturn_SUCCESS &&
        material.shininess > 0.0f) {
        source.Get(AI_MATKEY_SHININESS_STRENGTH, strength);
        material.specular = strength * to_glm(specular);
        material.illumination_model = 2;
    }

    aiColor3D emission(0.0f, 0.0f, 0.0f);
    source.Get(AI_MATKEY_COLOR_EMISSIVE, emission);
    const bool is_black = emission.IsBlack();
    if (source.GetTexture(aiTextureType_EMISSIVE, 0, &picture) != aiReturn_SUCCESS) {
        material.emission = to_glm(emission);
    } else if (!is_black || !is_gltf_) { // which are not multiplied in other formats
        material.emissive_map = picture_name(picture);
        material.emissive_factor = is_black ? glm::vec3(1.0f) : to_glm(emission);
    }
    if (source.GetTexture(aiTextureType_NORMALS, 0, &picture) == aiReturn_SUCCESS) {
        material.normal_map = picture_name(picture);
        if (source.Get("$tex.scale", aiTextureType_NORMALS, 0, factor) == aiReturn_SUCCESS &&
            factor != 1.0f) {
            note("scales of normal maps");
        }
    }

    aiString mode;
    const bool has_mode = source.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS;
    const std::string alpha = mode.C_Str();
    if (alpha == "MASK") {
        material.cutout_map = material.diffuse_map;
        source.Get(AI_MATKEY_GLTF_ALPHACUTOFF, material.cutoff);
    } else if (has_mode) {
        material.cutoff = 0.0f; // the alpha channel cuts nothing
    }
    if (alpha == "BLEND") {
        material.opacity = color.a;
        if (!material.diffuse_map.empty()) {
            note("blending by the opacity of a picture");
        }
    }
    if (!has_mode && source.Get(AI_MATKEY_OPACITY, factor) == aiReturn_SUCCESS && factor > 0.0f) {
        material.opacity = factor; // at 0, nothing would be seen: a fault of many exports
    }
    if (!has_mode && source.GetTexture(aiTextureType_OPACITY, 0, &picture) == aiReturn_SUCCESS) {
        material.cutout_map = picture_name(picture);
    }
    count_textures(source);
    mesh_.materials.push_back(std::move(material));
}

void Importing::add_nodes(const aiNode& node, const NodePlace& outer) {
    const NodePlace place = outer * node.mTransformation;
    const std::string name = node.mName.C_Str();
    place_of_node_.emplace(name, place);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        add_mesh(*scene_.mMeshes[node.mMeshes[i]], place, name,
                 node.mNumMeshes > 1 ? static_cast<int>(i) : -1);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
        add_nodes(*node.mChildren[i], place);
    }
}

// A list that some meshes have and others do not is filled up for these.
template <class Value>
void fill_up(std::vector<Value>& values, std::size_t count, const Value& filling) {
    if (!values.empty()) {
        values.resize(count, filling);
    }
}

void Importing::add_mesh(const aiMesh& source, const NodePlace& place, const std::string& object,
                         int primitive) {
    const std::size_t first = mesh_.positions.size();
    const std::size_t end = first + source.mNumVertices;
    if (end > std::size_t{1} << 30u) {
        throw InputError("it has more vertices than can be counted here. Leave some out.");
    }
    mesh_.groups.push_back(
        {mesh_.sizes.size(), static_cast<std::int32_t>(source.mMaterialIndex), primitive, object});
    const glm::dmat3 for_normals = normal_matrix(place.linear);
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
        mesh_.positions.push_back(applied(place, to_glm(source.mVertices[i])));
    }
    if (source.HasNormals()) {
        mesh_.normals.resize(first, glm::vec3(0.0f));
        for (unsigned i = 0; i < source.mNumVertices; ++i) {
            const glm::dvec3 normal = for_normals * to_glm(source.mNormals[i]);
            const double length = glm::length(normal);
            mesh_.normals.push_back(length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f));
        }
    }
    if (source.HasTextureCoords(0)) {
        mesh_.texture_coordinates.resize(first, glm::vec2(0.0f));
        for (unsigned i = 0; i < source.mNumVertices; ++i) {
            const aiVector3D& at = source.mTextureCoords[0][i];
            mesh_.texture_coordinates.emplace_back(at.x, at.y);
        }
    }
    if (source.HasVertexColors(0)) {
        mesh_.colors.resize(first, glm::vec3(1.0f));
        for (unsigned i = 0; i < source.mNumVertices; ++i) {
            const aiColor4D& color = source.mColors[0][i];
            mesh_.colors.emplace_back(color.r, color.g, color.b);
        }
    }
    fill_up(mesh_.normals, end, glm::vec3(0.0f));
    fill_up(mesh_.texture_coordinates, end, glm::vec2(0.0f));
    fill_up(mesh_.colors, end, glm::vec3(1.0f));
    if (source.HasTextureCoords(1)) {
        note("second texture coordinates");
    }
    if (source.HasBones()) {
        note("skins (it is shown as its file places its vertices)");
    }
    if (source.mNumAnimMeshes > 0) {
        note("shape keys");
    }
    add_faces(source, static_cast<std::uint32_t>(first), glm::determinant(place.linear) < 0.0);
}

void Importing::add_faces(const aiMesh& source, std::uint32_t first_vertex, bool mirrors) {
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        if (face.mNumIndices < 3) {
            note("lines and points");
            continue;
        }
        mesh_.sizes.push_back(face.mNumIndices);
        for (unsigned at = 0; at < face.mNumIndices; ++at) {
            const unsigned corner = mirrors ? face.mNumIndices - 1 - at : at;
            mesh_.corners.push_back(first_vertex + face.mIndices[corner]);
        }
    }
}

// Of a glTF camera, Assimp before version 5.3 gives the vertical angle times the aspect ratio.
double Importing::vertical_angle(const aiCamera& camera) const {
    const double aspect = camera.mAspect > 0.0f ? static_cast<double>(camera.mAspect) : 1.0;
    const double across = static_cast<double>(camera.mHorizontalFOV);
    const bool is_product = is_gltf_ && (aiGetVersionMajor() < 5 ||
                                         (aiGetVersionMajor() == 5 && aiGetVersionMinor() < 3));
    return is_product ? across / aspect : 2.0 * std::atan(std::tan(0.5 * across) / aspect);
}

void Importing::add_cameras() {
    if (scene_.mNumCameras == 0) {
        return;
    }
    if (scene_.mNumCameras > 1) {
        not_shown_["cameras after the first"] = static_cast<int>(scene_.mNumCameras) - 1;
    }
    const aiCamera& source = *scene_.mCameras[0];
    const auto node = place_of_node_.find(source.mName.C_Str());
    const NodePlace place = node == place_of_node_.end() ? NodePlace{} : node->second;
    // Of a glTF camera, Assimp gives the place of its node twice.
    const glm::dvec3 position = is_gltf_ ? glm::dvec3(0.0) : to_glm(source.mPosition);
    Camera camera;
    camera.eye = glm::vec3(applied(place, position));
    camera.target = glm::vec3(applied(place, position + glm::normalize(to_glm(source.mLookAt))));
    camera.up = glm::vec3(place.linear * to_glm(source.mUp));
    camera.vertical_field_of_view = static_cast<float>(glm::degrees(vertical_angle(source)));
    mesh_.camera = camera;
}

// Of a light, its place and its colour: here it does not fade, so its strength means nothing.
void Importing::add_lights() {
    for (unsigned i = 0; i < scene_.mNumLights; ++i) {
        const aiLight& source = *scene_.mLights[i];
        const bool has_place =
            source.mType == aiLightSource_POINT || source.mType == aiLightSource_SPOT;
        const glm::vec3 color = to_glm(source.mColorDiffuse);
        const float greatest = std::max({color.x, color.y, color.z});
        if (!has_place || !(greatest > 0.0f) || mesh_.lights.size() == most_lights) {
            note("lights without a place, or after the first 16");
            continue;
        }
        const auto node = place_of_node_.find(source.mName.C_Str());
        const NodePlace place = node == place_of_node_.end() ? NodePlace{} : node->second;
        Light light;
        light.position = glm::vec3(applied(place, to_glm(source.mPosition)));
        light.color = color / greatest;
        mesh_.lights.push_back(light);
    }
}

MeshFile Importing::mesh() {
    add_pictures();
    std::set<unsigned> used;
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
        used.insert(scene_.mMeshes[i]->mMaterialIndex);
    }
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) {
        const auto before = not_shown_;
        add_material(*scene_.mMaterials[i]);
        if (!used.contains(i)) { // as the one that Assimp adds to every glTF file
            not_shown_ = before;
        }
    }
    if (scene_.mRootNode != nullptr) {
        add_nodes(*scene_.mRootNode, {});
    }
    add_cameras();
    add_lights();
    if (scene_.mNumAnimations > 0) {
        not_shown_["animations"] = static_cast<int>(scene_.mNumAnimations);
    }
    for (const auto& [what, count] : not_shown_) {
        mesh_.messages.push_back(fmt::format("{} are not shown: {}.", what, count));
    }
    return std::move(mesh_);
}

} // namespace

MeshFile import_file(const std::string& path) {
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(path, 0);
    if (scene == nullptr) {
        throw InputError(std::string("it cannot be imported (") + importer.GetErrorString() +
                         "). Check the export, or try another format.");
    }
    MeshFile mesh = Importing(*scene, path).mesh();
    if (mesh.sizes.empty()) {
        throw InputError("it holds no face that can be drawn. Check the export.");
    }
    return mesh;
}

} // namespace raysteps
