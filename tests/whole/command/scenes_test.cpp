#include "catch.h"
#include "image/image_file.h"
#include "programs.h"
#include "ray_bytes.h"
#include "scene/load_scene.h"

#include <algorithm>
#include <sstream>

using namespace raysteps;

namespace {

constexpr long pixel_count = 432; // 24 x 18

// The names of the scenes, without their parameters.
std::vector<std::string> scene_names(const Workplace& workplace, const std::string& chapter) {
    const Outcome outcome = workplace.run(chapter, {"--list-scenes"});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.errors.empty());
    std::vector<std::string> names;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
        names.push_back(line.substr(0, line.find_first_of(": ")));
    }
    return names;
}

// Renders a scene and returns the bits of its picture.
std::string picture_of(const Workplace& workplace, const std::string& chapter,
                       const std::string& scene, const std::string& picture) {
    const Outcome outcome =
        workplace.run(chapter, {"--scene", scene, "--size", "24x18", "--out", "pictures"});
    CAPTURE(chapter, scene, outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return workplace.read("pictures/" + picture);
}

// Prints a scene to a file, and reads it back.
void check_printed_scene(const Workplace& workplace, const std::string& scene,
                         const std::string& picture) {
    const Outcome printed =
        workplace.run("03_shading", {"--scene", scene, "--size", "24x18", "--print-scene"});
    REQUIRE(printed.exit_code == 0);
    workplace.write("printed.toml", printed.output);
    const std::string bits = picture_of(workplace, "03_shading", scene, picture);
    REQUIRE(bits.size() > std::size_t{pixel_count} * 12);
    CHECK(picture_of(workplace, "03_shading", "printed.toml", "printed.pfm") == bits);
}

} // namespace

TEST_CASE("every program lists the same scenes", "[command]") {
    const Workplace workplace("list_scenes");
    const std::vector<std::string> names = scene_names(workplace, "01_rays");
    CHECK(names.size() >= 10);
    CHECK(std::count(names.begin(), names.end(), "cornell_box") == 1);
    CHECK(scene_names(workplace, "02_triangles") == names);
    CHECK(scene_names(workplace, "03_shading") == names);
}

TEST_CASE("every listed scene loads with its usual parameters", "[command]") {
    const Workplace workplace("load_scenes");
    for (const std::string& name : scene_names(workplace, "01_rays")) {
        const Outcome outcome = workplace.run("01_rays", {"--scene", name, "--print-scene"});
        CAPTURE(name, outcome.errors);
        CHECK(outcome.exit_code == 0);
        CHECK_THAT(outcome.output, starts_with_text("sample = \"" + name));
        CHECK_THAT(outcome.output, contains_text("\n[camera]\n"));
    }
}

TEST_CASE("a printed scene gives the same picture bit for bit", "[command]") {
    const Workplace workplace("print_scene");
    workplace.write("two.obj", two_triangles);
    check_printed_scene(workplace, "two.obj", "two.pfm");
    check_printed_scene(workplace, "cornell_box", "cornell_box.pfm");
}

TEST_CASE("a printed scene keeps the camera of the command line", "[command]") {
    const Workplace workplace("print_camera");
    const Outcome outcome = workplace.run(
        "01_rays", {"--scene", "cornell_box", "--camera", "-1,2,3,4,5,6,50", "--print-scene"});
    CHECK_THAT(outcome.output, contains_text("eye = [-1.0, 2.0, 3.0]"));
    CHECK_THAT(outcome.output, contains_text("vertical_field_of_view = 50.0"));
}

TEST_CASE("a scene without triangles shows the background", "[command]") {
    const Workplace workplace("no_triangles");
    workplace.write("empty.obj", "# nothing\n");
    const glm::vec3 background = load_scene((workplace / "empty.obj").string(), 1.0f).background;
    picture_of(workplace, "02_triangles", "empty.obj", "empty_normals.pfm");
    picture_of(workplace, "03_shading", "empty.obj", "empty.pfm");
    for (const std::string file : {"pictures/empty_normals.pfm", "pictures/empty.pfm"}) {
        const Image image = read_pfm(workplace / file);
        CAPTURE(file);
        CHECK(image.width == 24);
        CHECK(std::count(image.pixels.begin(), image.pixels.end(), background) == pixel_count);
    }
    picture_of(workplace, "01_rays", "empty.obj", "directions.pfm");
}

TEST_CASE("one triangle is counted in the singular", "[command]") {
    const Workplace workplace("one_triangle");
    workplace.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    workplace.write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
    const auto output_for = [&](const std::string& scene) {
        return workplace.run("02_triangles", {"--scene", scene, "--size", "8"}).output;
    };
    CHECK_THAT(output_for("one.obj"), contains_text(", 1 triangle, "));
    CHECK_THAT(output_for("two.obj"), contains_text(", 2 triangles, "));
}
