#include "scene/import/mesh_file.h"

#include "basics/error.h"
#include "catch.h"

#include <glm/common.hpp>

#include <limits>

using namespace raysteps;

namespace {

MeshFile small_mesh() {
    MeshFile mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 5e6 + 0.125}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.corners = {0, 1, 2, 3, 0, 2, 1};
    mesh.sizes = {4, 3};
    mesh.groups = {{0, 0, -1, "plate"}, {1, 1, 2, "wedge"}};
    mesh.materials.resize(2);
    mesh.materials[1].name = "glass";
    mesh.materials[1].cutout_map = "a.glb:*0";
    mesh.materials[1].normal_map = "normal.png";
    mesh.materials[1].emissive_map = "glow.png";
    mesh.materials[1].emissive_factor = {1, 2, 3};
    mesh.lights = {{{1, 2, 3}, {1, 0.5f, 0.25f}}};
    mesh.pictures = {{"a.glb:*0", std::string("\0\x89PNG", 5)}};
    mesh.camera = Camera{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 30.0f};
    mesh.messages = {"animations are not shown: 1."};
    return mesh;
}

// The sentence of the InputError that the call throws; empty where it throws nothing.
template <class Call>
std::string refusal_of_mesh(const Call& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

MeshFile read_again(const MeshFile& mesh) {
    return read_mesh_file(write_mesh_file(mesh), "a.glb");
}

std::string error_of_mesh(const MeshFile& mesh) {
    return refusal_of_mesh([&] { read_again(mesh); });
}

} // namespace

TEST_CASE("a mesh file gives back what was written", "[import]") {
    const MeshFile mesh = small_mesh();
    const MeshFile read = read_again(mesh);
    CHECK(read.positions == mesh.positions);
    CHECK(read.normals == mesh.normals);
    CHECK(read.texture_coordinates == mesh.texture_coordinates);
    CHECK(read.colors.empty());
    CHECK(read.corners == mesh.corners);
    CHECK(read.sizes == mesh.sizes);
    REQUIRE(read.groups.size() == 2);
    CHECK(read.groups[1].object == "wedge");
    CHECK(read.groups[1].primitive == 2);
    CHECK(read.materials[1].cutout_map == "a.glb:*0");
    CHECK(read.pictures[0].bytes == mesh.pictures[0].bytes);
    CHECK(read.lights[0].color == mesh.lights[0].color);
    CHECK(read.camera->vertical_field_of_view == 30.0f);
    CHECK(read.messages == mesh.messages);
}

TEST_CASE("a mesh file that was cut or changed is refused or sound", "[import]") {
    const std::string bytes = write_mesh_file(small_mesh());
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        CAPTURE(length);
        CHECK_THAT(refusal_of_mesh([&] { read_mesh_file(bytes.substr(0, length), "a.glb"); }),
                   starts_with_text("a.glb: what was imported cannot be used"));
    }
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        for (const char value : {'\0', '\x7f', '\xff'}) {
            std::string changed = bytes;
            changed[i] = value;
            refusal_of_mesh([&] {
                const MeshFile mesh = read_mesh_file(changed, "a.glb");
                for (const std::uint32_t corner : mesh.corners) {
                    REQUIRE(corner < mesh.positions.size());
                }
            });
        }
    }
    CHECK_THAT(refusal_of_mesh([&] { read_mesh_file(bytes + "x", "a.glb"); }),
               contains_text("goes on"));
}

TEST_CASE("a mesh whose parts do not fit together is refused", "[import]") {
    MeshFile mesh = small_mesh();
    mesh.corners[0] = 4;
    CHECK_THAT(error_of_mesh(mesh), contains_text("names a vertex that is not there"));
    mesh = small_mesh();
    mesh.sizes[0] = 5;
    CHECK_THAT(error_of_mesh(mesh), contains_text("do not have the corners"));
    mesh = small_mesh();
    mesh.groups[1].material = 2;
    CHECK_THAT(error_of_mesh(mesh), contains_text("groups are not in order"));
    mesh = small_mesh();
    mesh.groups.clear();
    CHECK_THAT(error_of_mesh(mesh), contains_text("belongs to no group"));
    mesh = small_mesh();
    mesh.normals.pop_back();
    CHECK_THAT(error_of_mesh(mesh), contains_text("different lengths"));
    mesh = small_mesh();
    mesh.positions[2].y = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(error_of_mesh(mesh), contains_text("a coordinate is not a number"));
}

TEST_CASE("values that no material can have are brought into their range", "[import]") {
    MeshFile mesh = small_mesh();
    mesh.materials[0].diffuse = {2.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()};
    mesh.materials[0].refractive_index = 0.0f;
    mesh.camera->target = mesh.camera->eye;
    const MeshFile read = read_again(mesh);
    CHECK(read.materials[0].diffuse == glm::vec3(1, 0, 0));
    CHECK(read.materials[0].refractive_index == 0.001f);
    CHECK(!read.camera);
}
