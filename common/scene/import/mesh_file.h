#pragma once

#include "scene/scene.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// Faces of one material that belong together, from the first on to the next group.
struct MeshGroup {
    std::uint64_t first_face = 0;
    std::int32_t material = 0;
    std::int32_t primitive = -1; // its number in the object, where it has several
    std::string object;
};

// What the importer hands over: a model as some library has read it, in world space. Normals,
// texture coordinates and colours are one for each position, or there are none.
struct MeshFile {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texture_coordinates;
    std::vector<glm::vec3> colors;
    std::vector<std::uint32_t> corners; // of all faces: positions
    std::vector<std::uint32_t> sizes;   // of each face: its corners
    std::vector<MeshGroup> groups;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::vector<EnclosedPicture> pictures;
    std::optional<Camera> camera;
    std::vector<std::string> messages; // without the file's name
};

// Bytes that read_mesh_file reads again on the same machine: the programs are built together.
std::string write_mesh_file(const MeshFile& mesh);

// The mesh of such bytes, in which every index is in range, every coordinate within
// greatest_coordinate and every value of a material in its own range; what is out of it was brought
// there. Throws InputError with the name of the path where the bytes are no such mesh.
MeshFile read_mesh_file(std::string_view bytes, const std::filesystem::path& path);

} // namespace raysteps
