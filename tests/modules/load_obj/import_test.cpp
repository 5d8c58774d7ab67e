#include "scene/import/load_import.h"

#include "basics/error.h"
#include "catch.h"
#include "first_fault.h"
#include "model_folder.h"
#include "scene/load_model.h"

#include <glm/geometric.hpp>

#include <optional>

using namespace raysteps;

namespace {

// The words of the importer, where the programs were built without its library.
bool is_absent(const std::string& sentence) {
    return sentence.find("Install the package libassimp-dev") != std::string::npos;
}

// The scene; none, with a word on it, where the library is missing.
std::optional<Scene> imported(const std::filesystem::path& path) {
    try {
        return load_model(path, Origin::near_model);
    } catch (const MachineError& error) {
        REQUIRE(is_absent(error.what()));
        WARN("skipped: built without libassimp-dev");
        return std::nullopt;
    }
}

std::string error_of_import(const std::filesystem::path& path) {
    try {
        load_import(path);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

constexpr const char* ascii_stl = "solid wedge\n"
                                  "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                  "vertex 0 1 0\nendloop\nendfacet\n"
                                  "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\n"
                                  "vertex 1 0 0\nendloop\nendfacet\nendsolid wedge\n";

// One triangle in a node that is moved by (5, 0, 0) and twice as large, under a camera; 36 bytes of
// positions, 24 of texture coordinates and 6 of indices.
constexpr const char* gltf = R"({
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"name": "leaf", "mesh": 0, "translation": [5, 0, 0], "scale": [2, 2, 2]},
          {"name": "eye", "camera": 0, "translation": [5, 0, 9]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1, "aspectRatio": 2}}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
"materials": [{"name": "green", "alphaMode": "MASK", "alphaCutoff": 0.25, "emissiveFactor": [1, 0.5, 0.25],
  "emissiveTexture": {"index": 0}, "normalTexture": {"index": 0, "scale": 0.5},
  "pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0.75, 1], "baseColorTexture": {"index": 0}}}],
"textures": [{"source": 0}], "images": [{"uri": "leaf.png"}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
              {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
              {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24},
                {"buffer": 0, "byteOffset": 60, "byteLength": 6}],
"buffers": [{"uri": "leaf.bin", "byteLength": 66}]})";

std::string gltf_buffer() {
    const float numbers[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 0};
    const std::uint16_t indices[3] = {0, 1, 2};
    return std::string(reinterpret_cast<const char*>(numbers), sizeof numbers) +
           std::string(reinterpret_cast<const char*>(indices), sizeof indices);
}

} // namespace

TEST_CASE("an STL file gives its triangles with the normals of its facets", "[import]") {
    const ModelFolder folder("stl");
    const auto scene = imported(folder.write("wedge.STL", ascii_stl));
    if (!scene) {
        return;
    }
    CHECK(first_fault(*scene).empty());
    REQUIRE(triangle_count(*scene) == 2);
    CHECK(scene->corners[1] == glm::vec3(1, 0, 0));
    CHECK(scene->normals[3] == glm::vec3(0, -1, 0));
    CHECK_THAT(name_of_triangle(*scene, 1),
               starts_with_text("wedge.STL") && contains_text("face 2"));
}

TEST_CASE("a glTF file gives its nodes materials camera and what is not shown", "[import]") {
    const ModelFolder folder("gltf");
    folder.write("leaf.bin", gltf_buffer());
    const auto scene = imported(folder.write("leaf.gltf", gltf));
    if (!scene) {
        return;
    }
    CHECK(first_fault(*scene).empty());
    REQUIRE(triangle_count(*scene) == 1);
    CHECK(scene->corners == std::vector<glm::vec3>{{5, 0, 0}, {7, 0, 0}, {5, 2, 0}});
    CHECK(scene->texture_coordinates[0] == glm::vec2(0, 0)); // v runs down in glTF, up here
    CHECK(name_of_triangle(*scene, 0) == "leaf.gltf, object \"leaf\", face 1");
    const Material& green = scene->materials.at(0);
    CHECK(green.name == "green");
    CHECK(green.diffuse == glm::vec3(0.25f, 0.5f, 0.75f));
    CHECK(green.cutoff == 0.25f);
    CHECK(green.cutout_map == green.diffuse_map);
    CHECK(green.emissive_map == green.diffuse_map);
    CHECK(green.emissive_factor == glm::vec3(1.0f, 0.5f, 0.25f));
    CHECK(green.emission == glm::vec3(0.0f)); // so it is no lamp
    CHECK(green.normal_map == green.diffuse_map);
    REQUIRE(scene->file_camera);
    CHECK(scene->file_camera->eye == glm::vec3(5, 0, 9));
    CHECK(glm::distance(glm::normalize(scene->file_camera->target - scene->file_camera->eye),
                        glm::vec3(0, 0, -1)) < 1e-6f);
    CHECK(scene->file_camera->vertical_field_of_view == Approx(28.648).epsilon(1e-4)); // 0.5
    const std::string messages = joined(scene->messages);
    CHECK_THAT(messages, contains_text("leaf.gltf: metallic factors are not shown: 1."));
    CHECK_THAT(messages, contains_text("leaf.gltf: scales of normal maps are not shown: 1."));
    CHECK_THAT(messages, contains_text("There is no texture \"leaf.png\"."));
}

TEST_CASE("a file that cannot be imported is one sentence", "[import]") {
    const ModelFolder folder("no_import");
    const std::string broken = error_of_import(folder.write("broken.glb", "glTF and no more"));
    CHECK((is_absent(broken) || broken.find("broken.glb: it cannot be imported") == 0 ||
           broken.find((folder.path() / "broken.glb").string() + ": it cannot be imported") == 0));
    CHECK_THAT(error_of_import(folder.path() / "gone.stl"), contains_text("there is no such file"));
    folder.write("bad.bin", "short");
    const std::string cut = error_of_import(folder.write(
        "cut.gltf", std::string(gltf).replace(std::string(gltf).find("leaf.bin"), 8, "bad.bin")));
    CHECK((is_absent(cut) || cut.find("cut.gltf: ") != std::string::npos));
}
