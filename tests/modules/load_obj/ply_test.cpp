#include "scene/ply/load_ply.h"

#include "basics/error.h"
#include "catch.h"
#include "first_fault.h"
#include "model_folder.h"

#include <algorithm>
#include <bit>
#include <cstring>

using namespace raysteps;

namespace {

constexpr const char* ascii_square = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\n"
                                     "property double x\nproperty double y\nproperty double z\n"
                                     "property uchar red\nproperty uchar green\n"
                                     "property uchar blue\nproperty float quality\n"
                                     "element face 2\nproperty list uchar int vertex_indices\n"
                                     "end_header\n"
                                     "0 0 0 255 0 0 0.5\n1 0 0 0 255 0 0.5\n"
                                     "1 1 0 0 0 255 0.5\n0 1 0 255 255 255 0.5\n"
                                     "4 0 1 2 3\n2 0 1\n";

// Bytes of numbers in one byte order.
class PlyBytes {
public:
    explicit PlyBytes(std::endian order) : order_(order) {}

    template <class Number>
    void add(Number number) {
        char raw[sizeof number];
        std::memcpy(raw, &number, sizeof number);
        if (order_ != std::endian::native) {
            std::reverse(raw, raw + sizeof number);
        }
        bytes.append(raw, sizeof number);
    }

    std::string bytes;

private:
    std::endian order_;
};

std::string binary_square(std::endian order) {
    const std::string name = order == std::endian::little ? "little" : "big";
    PlyBytes out(order);
    out.bytes = "ply\r\nformat binary_" + name +
                "_endian 1.0\r\nelement vertex 4\r\nproperty float64 x\r\nproperty float64 y\r\n"
                "property float64 z\r\nelement face 1\r\n"
                "property list uint8 uint32 vertex_index\r\nend_header\r\n";
    for (const double number : {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0}) {
        out.add(number);
    }
    out.add(std::uint8_t{4});
    for (const std::uint32_t index : {0u, 1u, 2u, 3u}) {
        out.add(index);
    }
    return out.bytes;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// The sentence of the InputError that the call throws; empty where it throws nothing.
template <class Call>
std::string refusal_of(const Call& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string error_of_ply(const std::string& bytes) {
    return refusal_of([&] { parse_ply(bytes, "a.ply"); });
}

} // namespace

TEST_CASE("an ASCII PLY file gives corners and colours and tells the rest", "[ply]") {
    const Scene scene = parse_ply(ascii_square, "square.ply");
    REQUIRE(triangle_count(scene) == 2);
    CHECK(first_fault(scene).empty());
    CHECK(scene.corners ==
          std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    REQUIRE(scene.corner_colors.size() == 6);
    CHECK(scene.corner_colors[1] == glm::vec3(0, 1, 0));
    CHECK(scene.corner_colors[5] == glm::vec3(1, 1, 1));
    CHECK(scene.materials[0].diffuse == glm::vec3(1.0f)); // the colours are the whole colour
    CHECK(scene.faces == std::vector<int>{1, 1});
    const std::string messages = joined(scene.messages);
    CHECK_THAT(messages, contains_text("The property \"quality\" of its elements \"vertex\" is not "
                                       "shown: 4."));
    CHECK_THAT(messages, contains_text("square.ply: face 2: A face with fewer than three corners "
                                       "was dropped."));
}

TEST_CASE("binary PLY files of both byte orders give the same", "[ply]") {
    const Scene text = parse_ply(ascii_square, "square.ply");
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const Scene scene = parse_ply(binary_square(order), "square.ply");
        CHECK(scene.corners == text.corners);
        CHECK(scene.normals == text.normals);
        CHECK(scene.corner_colors.empty());
    }
}

TEST_CASE("coordinates of a PLY file are read in double", "[ply]") {
    const std::string far =
        replaced(ascii_square, "1 1 0 0 0 255", "448262.125 5411932.0625 1 0 0 9");
    const std::string both = replaced(far, "0 0 0 255 0 0", "448260.5 5411930.5 0 0 0 0");
    const Scene scene = parse_ply(replaced(replaced(both, "1 0 0 0 255", "448262 5411930 0 0 255"),
                                           "0 1 0 255", "448260 5411932 0 255"),
                                  "far.ply", Origin::near_model);
    CHECK(glm::dvec3(scene.corners[2]) + scene.origin == glm::dvec3(448262.125, 5411932.0625, 1.0));
}

TEST_CASE("normals and texture coordinates of a PLY file are used", "[ply]") {
    const Scene scene = parse_ply("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                  "property float y\nproperty float z\nproperty float nx\n"
                                  "property float ny\nproperty float nz\nproperty float s\n"
                                  "property float t\nelement face 1\n"
                                  "property list uchar int vertex_indices\nend_header\n"
                                  "0 0 0 0 3 4 0.25 0.5\n1 0 0 0 3 4 1 0\n0 1 0 0 0 0 0 1\n"
                                  "3 0 1 2\n",
                                  "n.ply");
    CHECK(scene.normals[0] == glm::vec3(0.0f, 0.6f, 0.8f));
    CHECK(scene.normals[2] == glm::vec3(0, 0, 1)); // given none: the triangle's own
    CHECK(scene.texture_coordinates[0] == glm::vec2(0.25f, 0.5f));
}

TEST_CASE("strips of triangles turn every other one around", "[ply]") {
    const std::string head = "ply\nformat ascii 1.0\nhello\nelement vertex 5\nproperty float x\n"
                             "property float y\nproperty float z\nelement tristrips 1\n"
                             "property list int int vertex_indices\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
    const Scene scene = parse_ply(head + "9 0 1 2 3 -1 2 3 4 -1\n", "s.ply");
    REQUIRE(triangle_count(scene) == 3);
    for (const glm::vec3& normal : scene.normals) {
        CHECK(normal == glm::vec3(0, 0, 1));
    }
    CHECK(name_of_triangle(scene, 2) == "s.ply, face 3");
    CHECK_THAT(joined(scene.messages),
               contains_text("s.ply:3: PLY has no such line in its header, so it was skipped."));
}

TEST_CASE("a PLY file that cannot be used is refused with what is wrong", "[ply]") {
    const std::string text = ascii_square;
    CHECK_THAT(error_of_ply("solid"), contains_text("a.ply:"));
    CHECK_THAT(error_of_ply("obj\n"), contains_text("a.ply:1: a PLY file begins with"));
    CHECK_THAT(error_of_ply(replaced(text, "ascii", "xml")), contains_text("a.ply:2: there is no"));
    CHECK_THAT(error_of_ply(replaced(text, "double x", "real x")),
               contains_text("a.ply:5: PLY has no type \"real\""));
    CHECK_THAT(error_of_ply(replaced(text, "double x", "double w")),
               contains_text("no x, y and z"));
    CHECK_THAT(error_of_ply(replaced(text, "4 0 1 2 3", "4 0 1 2 4")),
               contains_text("face 1 names vertex 4 (from 0), but there are 4"));
    CHECK_THAT(error_of_ply(replaced(text, "4 0 1 2 3", "4 0 1 2 -3")),
               contains_text("face 1 names a vertex that is no whole number"));
    CHECK_THAT(error_of_ply(replaced(text, "0 0 0 255", "0 nan 0 255")),
               contains_text("a coordinate of vertex 0"));
    CHECK_THAT(error_of_ply(replaced(text, "element vertex 4", "element vertex 4000000000")),
               contains_text("it ends too early"));
    const std::string binary = binary_square(std::endian::little);
    for (std::size_t length = 0; length < binary.size(); ++length) {
        CHECK(!error_of_ply(binary.substr(0, length)).empty());
    }
}
