#include "first_fault.h"
#include "model_folder.h"

#include "scene/obj/load_obj.h"

#include "catch.h"

#include <ctime>

using namespace raysteps;

namespace {

Scene load_corpus(const std::string& name) {
    return load_obj(corpus_file(name));
}

// The right-angled triangle that most files of the corpus are about.
void check_right_triangle(const Scene& scene) {
    REQUIRE(triangle_count(scene) >= 1);
    CHECK(scene.corners[0] == glm::vec3(0, 0, 0));
    CHECK(scene.corners[1] == glm::vec3(1, 0, 0));
    CHECK(scene.corners[2] == glm::vec3(0, 1, 0));
}

} // namespace

TEST_CASE("a cube of quads becomes two triangles a face in the order of the file", "[obj]") {
    const Scene scene = load_corpus("cube.obj");
    REQUIRE(triangle_count(scene) == 12);
    CHECK(scene.name == "cube");
    CHECK(scene.corners[0] == glm::vec3(-1, -1, -1));
    CHECK(scene.corners[1] == glm::vec3(-1, 1, -1));
    CHECK(scene.corners[2] == glm::vec3(1, 1, -1));
    CHECK(scene.corners[3] == glm::vec3(-1, -1, -1));
    CHECK(scene.corners[5] == glm::vec3(1, -1, -1));
    CHECK(scene.texture_coordinates[5] == glm::vec2(0, 1));
    CHECK(scene.triangle_materials == std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2});
    REQUIRE(scene.models.size() == 1);
    CHECK(scene.models[0].path == corpus_file("cube.obj").string());
    CHECK(scene.lights.empty());
}

TEST_CASE("normals that the file gives are used at length 1", "[obj]") {
    const Scene scene = load_corpus("cube.obj");
    CHECK(scene.normals[0] == glm::vec3(0, 0, -1));
    CHECK(scene.normals[6] == glm::vec3(0, 0, 1));
    CHECK(scene.normals[12] == glm::vec3(0, -1, 0));
    CHECK_THAT(joined(scene.messages), contains_text("cube.obj: Its own normals are used."));
    CHECK(scene.messages.size() == 2); // and that its picture is not there
}

TEST_CASE("materials keep what the MTL file says", "[mtl]") {
    const Scene scene = load_corpus("cube.obj");
    REQUIRE(scene.materials.size() == 3);
    const Material& red = scene.materials[0];
    CHECK(red.name == "red");
    CHECK(red.diffuse == glm::vec3(0.75f, 0.25f, 0.125f));
    CHECK(red.specular == glm::vec3(0.5f, 0.5f, 0.25f));
    CHECK(red.shininess == 96.5f);
    CHECK(red.emission == glm::vec3(1, 2, 3));
    CHECK(red.illumination_model == 2);
    CHECK(red.opacity == 1.0f);
    CHECK(red.refractive_index == 1.0f);
    CHECK(red.transmission == glm::vec3(1));

    const Material& brick = scene.materials[1];
    CHECK(brick.name == "brick wall");
    CHECK(brick.diffuse == glm::vec3(0.5f));
    CHECK(brick.opacity == 0.75f);
    CHECK(brick.diffuse_map == corpus_file("pictures/brick wall.png").string());

    const Material& glass = scene.materials[2];
    CHECK(glass.diffuse == Material{}.diffuse);
    CHECK(glass.refractive_index == 1.5f);
    CHECK(glass.opacity == 0.125f);
    CHECK(glass.transmission == glm::vec3(0.5f, 0.75f, 1.0f));
    CHECK(glass.illumination_model == 7);
}

TEST_CASE("indices count back from the newest vertex and forward past it", "[obj]") {
    check_right_triangle(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\n", "m.obj"));
    check_right_triangle(load_corpus("forward_reference.obj"));
}

TEST_CASE("line ends and joined lines and comments and byte order marks change nothing", "[obj]") {
    for (const char* name : {"byte_order_mark.obj", "carriage_returns.obj", "old_macintosh.obj",
                             "continued_lines.obj", "comments_behind.obj", "no_line_end.obj",
                             "lines_and_curves.obj", "index_with_empty_parts.obj"}) {
        CAPTURE(name);
        check_right_triangle(load_corpus(name));
    }
    CHECK(triangle_count(load_corpus("continued_lines.obj")) == 2);
}

TEST_CASE("weights and colours behind a vertex are left out", "[obj]") {
    const Scene scene = load_corpus("weights_and_colors.obj");
    check_right_triangle(scene);
    CHECK(scene.texture_coordinates[0] == glm::vec2(0.25f, 0.0f));
    CHECK(scene.texture_coordinates[1] == glm::vec2(0.5f, 0.75f));
}

TEST_CASE("files without a face are empty scenes with a message", "[obj]") {
    for (const char* name : {"empty.obj", "only_a_byte_order_mark.obj", "only_vertices.obj"}) {
        CAPTURE(name);
        const Scene scene = load_corpus(name);
        CHECK(triangle_count(scene) == 0);
        CHECK(scene.materials.size() == 1);
        CHECK_THAT(joined(scene.messages), contains_text("holds no face that can be drawn"));
    }
}

TEST_CASE("triangles as small and as large as the limits allow keep their normals", "[obj]") {
    CHECK(load_corpus("tiny.obj").normals[0] == glm::vec3(0, 0, 1));
    CHECK(first_fault(load_corpus("huge.obj")).empty());
    CHECK(triangle_count(load_corpus("huge.obj")) == 1);
}

TEST_CASE("the bunny has 69666 triangles and loads in well under 2 seconds", "[obj]") {
    const std::filesystem::path bunny = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(bunny)) {
        WARN("the package glmark2-data is not installed");
        return;
    }
    const std::clock_t start = std::clock();
    const Scene scene = load_obj(bunny);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    CHECK(triangle_count(scene) == 69666);
    CHECK(first_fault(scene).empty());
    CHECK(seconds < 2.0);
    CHECK_THAT(joined(scene.messages), contains_text("every triangle is flat"));
}
