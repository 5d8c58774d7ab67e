#include "catch.h"
#include "support/scratch_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>

namespace {

// Runs the program in the folder. True where it ends well.
bool run_in(const ScratchFolder& folder, const std::string& options) {
    const std::string line =
        "cd '" + (folder / "").string() +
        "' && env -u DISPLAY -u WAYLAND_DISPLAY timeout 90 '" PROGRAM_07_COMPARE "' " + options +
        " >output 2>errors </dev/null";
    return std::system(line.c_str()) == 0; // NOLINT(cert-env33-c): every word is ours
}

std::size_t count_lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

const std::set<std::string> kinds{"primary", "shadow", "reflection", "bounce"};

} // namespace

TEST_CASE("table and JSON have a row for each scene and contender and kind", "[07][program]") {
    const ScratchFolder folder("07_rows");
    REQUIRE(run_in(folder, "--scenes compact:4,cornell_box --growth 1 --rounds 1 --size 16"));
    const auto numbers = nlohmann::json::parse(bytes_of(folder / "out/07_compare/compare.json"));
    CHECK_FALSE(std::filesystem::exists(folder / "out/07"));
    REQUIRE(numbers["scenes"].size() == 4); // two, and sphereflake:0 and :1
    const std::size_t contenders = numbers["scenes"][0]["structures"].size();
    CHECK(contenders == (numbers["embree"] == "" ? 10 : 12));
    for (const auto& scene : numbers["scenes"]) {
        std::set<std::string> found;
        for (const auto& kind : scene["rays"]) {
            CAPTURE(scene["scene"], kind["kind"]);
            found.insert(kind["kind"].get<std::string>());
            CHECK(kind["walks"].size() == contenders);
            CHECK(kind.contains("best_walk"));
            CHECK(kind.contains("ratio_to_embree") == (numbers["embree"] != ""));
            for (const auto& walk : kind["walks"]) {
                CHECK(walk["lowest"] > 0.0);
                CHECK(walk["lowest"] <= walk["million_rays_per_second"]);
                CHECK(walk["million_rays_per_second"] <= walk["highest"]);
            }
        }
        CHECK(found == kinds);
    }
    CHECK(numbers["claims"].size() == 3 * kinds.size() + 1);
    CHECK_FALSE(numbers["growth"].empty());
    const std::string csv = bytes_of(folder / "out/07_compare/compare.csv");
    CHECK(count_lines(csv) == 1 + 4 * kinds.size() * contenders);
    for (const std::string& kind : kinds) {
        CHECK(std::filesystem::exists(folder / ("out/07_compare/growth_" + kind + ".png")));
    }
}

TEST_CASE("the JSON of a comparison is valid by its schema", "[07][program]") {
    const ScratchFolder folder("07_schema");
    REQUIRE(run_in(folder, "--scenes compact:4 --growth 1 --rounds 1 --size 16 --json own.json"));
    const auto complaints = [&](const std::string& file) {
        const std::string line = "python3 -m jsonschema -i '" + (folder / file).string() +
                                 "' '" RAYSTEPS_SOURCE_DIR
                                 "/chapters/07_compare/compare.schema.json' >'" +
                                 (folder / "complaints").string() + "' 2>&1";
        const bool valid = std::system(line.c_str()) == 0; // NOLINT(cert-env33-c): as above
        return valid ? "" : bytes_of(folder / "complaints");
    };
    CHECK(complaints("own.json") == "");
    auto numbers = nlohmann::json::parse(bytes_of(folder / "own.json"));
    numbers["scenes"][0]["rays"][0]["walks"][0].erase("cores");
    std::ofstream(folder / "less.json") << numbers;
    CHECK_THAT(complaints("less.json"), contains_text("'cores' is a required property"));
}

TEST_CASE("a scene and a structure of the own are compared alone", "[07][program]") {
    const ScratchFolder folder("07_alone");
    REQUIRE(run_in(folder, "--scene compact:4 --structure kd_ropes --split median --embree off "
                           "--rounds 1 --size 16 --json own.json"));
    const auto numbers = nlohmann::json::parse(bytes_of(folder / "own.json"));
    REQUIRE(numbers["scenes"].size() == 1);
    CHECK(numbers["embree"] == "");
    CHECK(numbers["scenes"][0]["structures"].size() == 1);
    CHECK(numbers["growth"].empty());
    CHECK_FALSE(numbers["scenes"][0]["rays"][0].contains("ratio_to_embree"));
}

TEST_CASE("a slow walk is measured with a part of the rays and says so", "[07][program]") {
    const ScratchFolder folder("07_part");
    REQUIRE(run_in(folder, "--scene stadium:2 --structure grid --embree off --rounds 1 --size 64 "
                           "--most-seconds 0.000001 --json own.json"));
    const auto numbers = nlohmann::json::parse(bytes_of(folder / "own.json"));
    const auto walk = numbers["scenes"][0]["rays"][0]["walks"][0];
    CHECK(walk["of"] == 64 * 64);
    CHECK(walk["rays"] == 64); // one run of 64 rays: not less
    CHECK_THAT(bytes_of(folder / "output"), contains_text("* too slow for all rays"));
}

TEST_CASE("builds are compared without any tracing", "[07][program][builds]") {
    const ScratchFolder folder("07_builds");
    const bool done = run_in(folder, "--builds --scenes compact:4,soup:1000 --rounds 2");
    const std::string errors = bytes_of(folder / "errors");
    CAPTURE(errors);
    if (errors.find("built without Embree") != std::string::npos) {
        CHECK_FALSE(done);
        return;
    }
    REQUIRE(done);
    CHECK(count_lines(bytes_of(folder / "out/07_compare/builds.csv")) == 3);
    CHECK(bytes_of(folder / "output").find("rtcBuildBVH") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "out/07_compare/compare.json"));
}
