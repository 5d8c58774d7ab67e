#include "catch.h"
#include "image/image_file.h"
#include "programs.h"
#include "ray_bytes.h"

#include <nlohmann/json.hpp>

namespace {

const std::vector<std::string> structures{"every_triangle", "grid",         "grid_mailbox",
                                          "kd_restart",     "kd_backtrack", "kd_short_stack",
                                          "kd_ropes"};

} // namespace

TEST_CASE("every structure gives the same file of hits in every program that traces",
          "[command][structure]") {
    const Workplace workplace("structures");
    workplace.write("two.obj", two_triangles);
    workplace.write("rays.f32", ray_bytes({{0.25f, 0.5f, 1.0f, 0.0f, 0.0f, -1.0f, 0.0f, 100.0f},
                                           {0.25f, 0.5f, 1.0f, 0.0f, 0.0f, -1.0f, 1.5f, 100.0f},
                                           {2.0f, 2.0f, 1.0f, 0.0f, 0.0f, -1.0f, 0.0f, 7.0f},
                                           {0.5f, 0.0f, -4.0f, 0.0f, 0.0f, 1.0f, 0.0f, 9.0f}}));
    const std::vector<std::string> options{"--scene",  "two.obj", "--rays",
                                           "rays.f32", "--hits",  "hits.f32"};
    REQUIRE(workplace.run("02_triangles", options).exit_code == 0);
    const std::string expected = workplace.read("hits.f32");
    REQUIRE(expected.size() == 4 * 16);
    for (const std::string chapter : {"02_triangles", "04_grid", "06_bvh", "07_compare"}) {
        for (const std::string& structure : structures) {
            std::vector<std::string> arguments = options;
            arguments.insert(arguments.end(), {"--structure", structure});
            const Outcome outcome = workplace.run(chapter, arguments);
            CAPTURE(chapter, structure, outcome.errors);
            CHECK(outcome.exit_code == 0);
            CHECK(workplace.read("hits.f32") == expected);
        }
    }
}

TEST_CASE("an unknown structure is refused with the names of all", "[command][refusal]") {
    const Workplace workplace("structure_unknown");
    for (const std::string chapter :
         {"02_triangles", "03_shading", "04_grid", "05_kd_tree", "06_bvh", "07_compare"}) {
        check_refusal(workplace, chapter, {"--structure", "octree"}, 2,
                      {"--structure octree", "every_triangle, fastest, grid, ", "kd_ropes, "});
    }
}

TEST_CASE("values that no builder can use are refused with the option", "[command][refusal]") {
    const Workplace workplace("structure_values");
    const std::vector<std::string> scene{"--scene", "compact:4", "--structure"};
    const auto refuse = [&](const std::string& structure, const std::string& option,
                            const std::string& value, const std::vector<std::string>& fragments) {
        check_refusal(workplace, "05_kd_tree",
                      {"--scene", "compact:4", "--structure", structure, option, value}, 2,
                      fragments);
    };
    refuse("grid", "--density", "many", {"--density many", "number"});
    refuse("grid", "--density", "nan", {"--density nan"});
    refuse("grid", "--resolution", "-3", {"--resolution -3"});
    refuse("kd_ropes", "--split", "magic", {"--split magic", "area", "median"});
    refuse("kd_ropes", "--depth", "deep", {"--depth deep"});
    refuse("kd_ropes", "--density", "4", {"--density", "kd_ropes", "--split"});
    refuse("every_triangle", "--density", "4", {"--density", "every_triangle"});
}

TEST_CASE("a structure that takes too much memory is refused before it is built",
          "[command][refusal]") {
    const Workplace workplace("structure_memory");
    check_refusal(workplace, "04_grid",
                  {"--scene", "compact:4", "--resolution", "500", "--memory-limit", "16"}, 2,
                  {"--memory-limit", "16", "MiB"});
    check_refusal(workplace, "05_kd_tree", {"--scene", "soup:100000", "--memory-limit", "1"}, 2,
                  {"1 MiB", "--depth"});
}

TEST_CASE("a heat map of what a walk did stands over its legend", "[command][structure]") {
    const Workplace workplace("structure_views");
    for (const std::string view : {"visits", "tests"}) {
        const Outcome outcome = workplace.run(
            "05_kd_tree", {"--scene", "compact:4", "--size", "200", "--view", view, "--out", "."});
        CAPTURE(outcome.errors);
        CHECK(outcome.exit_code == 0);
        const raysteps::Image image =
            raysteps::read_picture(workplace / ("compact_4_kd_restart_" + view + ".png"));
        CHECK(image.width >= 200);
        CHECK(image.height > 220);
    }
}

TEST_CASE("measure prints a table and writes its numbers", "[command][structure]") {
    const Workplace workplace("structure_measure");
    const Outcome outcome = workplace.run("05_kd_tree", {"--scene", "compact:4", "--size", "32",
                                                         "--measure", "--json", "costs.json"});
    CAPTURE(outcome.errors);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.output, contains_text("kd_ropes"));
    const auto numbers = nlohmann::json::parse(workplace.read("costs.json"));
    const auto& scene = numbers.at("scenes").at(0);
    REQUIRE(scene.at("structures").size() == 5);
    for (const auto& structure : scene.at("structures")) {
        CHECK(structure.at("facts").contains("memory_bytes"));
    }
    CHECK(scene.at("kinds").size() == 3);
    for (const auto& kind : scene.at("kinds")) {
        CHECK(kind.at("walks").size() == 5);
        for (const auto& walk : kind.at("walks")) {
            CHECK(walk.at("million_rays_per_second").get<double>() > 0.0);
            CHECK(walk.at("visits_per_ray").get<double>() > 0.0);
        }
    }
}

TEST_CASE("the plot of chapter 04 is drawn with its script beside it", "[command][structure]") {
    const Workplace workplace("structure_plot");
    const Outcome outcome =
        workplace.run("04_grid", {"--scene", "compact:4", "--size", "32", "--plot", "--out", "."});
    CAPTURE(outcome.errors);
    CHECK(outcome.exit_code == 0);
    const raysteps::Image image = raysteps::read_picture(workplace / "compact_4_resolution.png");
    CHECK(image.width == 960);
    CHECK_THAT(workplace.read("compact_4_resolution.gp"), contains_text("triangles tested"));
}
