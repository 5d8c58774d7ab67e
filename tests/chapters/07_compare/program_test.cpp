#include "catch.h"
#include "support/scratch_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

namespace {

// Runs the program in the folder. True where it ends well.
bool run_in(const ScratchFolder& folder, const std::string& options,
            const std::string& environment = "") {
    const std::string line =
        "cd '" + (folder / "").string() + "' && env -u DISPLAY -u WAYLAND_DISPLAY " + environment +
        " timeout 90 '" PROGRAM_07_COMPARE "' " + options + " >output 2>errors </dev/null";
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
    CHECK(contenders == (numbers["embree"] == "" ? 12 : 14));
    for (const auto& scene : numbers["scenes"]) {
        std::set<std::string> found;
        for (const auto& kind : scene["kinds"]) {
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

TEST_CASE("parts of a comparison that ran by themselves are joined, and missing ones are named",
          "[07][program]") {
    const ScratchFolder folder("07_jobs");
    const std::string asked = "--scenes compact:4,cornell_box --growth -1 --rounds 1 --size 16 "
                              "--structure grid,kd_ropes,bvh_ordered ";
    REQUIRE(run_in(folder, asked + "--jobs-file jobs --results parts"));
    const std::string jobs = bytes_of(folder / "jobs");
    REQUIRE(count_lines(jobs) == 2);
    CHECK_FALSE(run_in(folder, "--merge parts"));
    CHECK_THAT(bytes_of(folder / "errors"), contains_text("no part has left figures there"));
    std::ofstream(folder / "one") << jobs.substr(0, jobs.find('\n'));
    const auto run_jobs = [&](const std::string& file) {
        const std::string line = "env -u DISPLAY -u WAYLAND_DISPLAY sh '" +
                                 (folder / file).string() + "' >/dev/null 2>&1";
        return std::system(line.c_str()) == 0; // NOLINT(cert-env33-c): every word is ours
    };
    REQUIRE(run_jobs("one"));
    CHECK_FALSE(run_in(folder, "--merge parts"));
    CHECK_THAT(bytes_of(folder / "errors"),
               contains_text("1 of 2 parts are missing: cornell_box."));
    CHECK_THAT(bytes_of(folder / "output"), contains_text(jobs.substr(jobs.find('\n') + 1)));
    const auto some = nlohmann::json::parse(bytes_of(folder / "out/07_compare/compare.json"));
    CHECK(some["scenes"].size() == 1);
    REQUIRE(run_jobs("jobs"));
    REQUIRE(run_in(folder, "--merge parts"));
    const auto all = nlohmann::json::parse(bytes_of(folder / "out/07_compare/compare.json"));
    REQUIRE(all["scenes"].size() == 2);
    CHECK(all["head"]["scenes"].size() == 2);
    CHECK(all["claims"].size() == 3 * kinds.size() + 1);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string name = all["scenes"][i]["scene"];
        CAPTURE(name);
        const std::string file = name == "cornell_box" ? "cornell_box" : "compact_4";
        const auto part = nlohmann::json::parse(bytes_of(folder / ("parts/" + file + ".json")));
        CHECK(all["scenes"][i] == part["scenes"][0]);
    }
}

TEST_CASE("the JSON of a comparison is valid by its schema", "[07][program]") {
    const ScratchFolder folder("07_schema");
    REQUIRE(run_in(folder, "--scenes compact:4 --growth 1 --rounds 1 --size 16 --json own.json"));
    const auto complaints = [&](const std::string& file) {
        const std::string line = "python3 -m jsonschema --base-uri 'file://" RAYSTEPS_SOURCE_DIR
                                 "/chapters/07_compare/' -i '" +
                                 (folder / file).string() +
                                 "' '" RAYSTEPS_SOURCE_DIR
                                 "/chapters/07_compare/compare.schema.json' >'" +
                                 (folder / "complaints").string() + "' 2>&1";
        const bool valid = std::system(line.c_str()) == 0; // NOLINT(cert-env33-c): as above
        return valid ? "" : bytes_of(folder / "complaints");
    };
    CHECK(complaints("own.json") == "");
    auto numbers = nlohmann::json::parse(bytes_of(folder / "own.json"));
    numbers["scenes"][0]["kinds"][0]["walks"][0].erase("busy_cores");
    std::ofstream(folder / "less.json") << numbers;
    CHECK_THAT(complaints("less.json"), contains_text("'busy_cores' is a required property"));
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
    CHECK_FALSE(numbers["scenes"][0]["kinds"][0].contains("ratio_to_embree"));
}

TEST_CASE("a slow walk is measured with a part of the rays and says so", "[07][program]") {
    const ScratchFolder folder("07_part");
    REQUIRE(run_in(folder, "--scene stadium:2 --structure grid --embree off --rounds 1 --size 64 "
                           "--most-seconds 0.000001 --json own.json"));
    const auto numbers = nlohmann::json::parse(bytes_of(folder / "own.json"));
    const auto walk = numbers["scenes"][0]["kinds"][0]["walks"][0];
    CHECK(walk["all_rays"] == 64 * 64);
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

TEST_CASE("one structure with several options takes part several times", "[07][program]") {
    const ScratchFolder folder("07_options");
    REQUIRE(run_in(folder, "--scenes compact:4 --growth 1 --rounds 1 --size 16 --embree off "
                           "--structure bvh_skip,bvh_skip:split=median:bins=8,bvh_ordered:bins=8 "
                           "--split sweep --json own.json"));
    const std::vector<std::string> names{"bvh_skip", "bvh_skip:split=median:bins=8",
                                         "bvh_ordered:bins=8"};
    const auto numbers = nlohmann::json::parse(bytes_of(folder / "own.json"));
    for (const auto& kind : numbers["scenes"][0]["kinds"]) {
        REQUIRE(kind["walks"].size() == names.size());
        for (std::size_t i = 0; i < names.size(); ++i) {
            CHECK(kind["walks"][i]["contender"] == names[i]);
        }
    }
    const auto& builders = numbers["head"]["builders"];
    CHECK(builders[names[0]]["split"] == "sweep");
    CHECK(builders[names[1]]["split"] == "median");
    CHECK(builders[names[1]]["bins"] == "8");
    CHECK(builders[names[2]]["split"] == "sweep");
    const auto& kind = numbers["scenes"][0]["kinds"][0];
    CHECK(kind["walks"][0]["visits_per_ray"] != kind["walks"][1]["visits_per_ray"]);
    std::set<std::string> drawn;
    for (const auto& line : numbers["growth"]) {
        drawn.insert(line["contender"].get<std::string>());
    }
    CHECK(drawn == std::set<std::string>(names.begin(), names.end()));
    CHECK_THAT(bytes_of(folder / "output"), contains_text(names[1] + " primary"));
    CHECK_THAT(bytes_of(folder / "out/07_compare/compare.csv"), contains_text("," + names[1]));
}

TEST_CASE("structures and options that there are not are refused in a sentence",
          "[07][program][refusal]") {
    const ScratchFolder folder("07_wrong_structures");
    const auto refusal = [&](const std::string& options) {
        CHECK_FALSE(run_in(folder, "--scene compact:4 --rounds 1 --size 16 " + options));
        return bytes_of(folder / "errors");
    };
    CHECK_THAT(refusal("--structure grid,octree:split=median"),
               contains_text("--structure octree") && contains_text("kd_ropes"));
    CHECK_THAT(refusal("--structure grid:split=median"),
               contains_text("--split median: not an option of grid"));
    CHECK_THAT(refusal("--structure bvh_skip:split=magic"),
               contains_text("--split magic") && contains_text("sweep"));
    CHECK_THAT(refusal("--structure bvh_skip:split"), contains_text("NAME:option=value"));
    CHECK_THAT(refusal("--structure bvh_skip:bins=8:bins=9"), contains_text("bins is given twice"));
    CHECK_THAT(refusal("--structure grid,grid"), contains_text("grid is named twice"));
    CHECK_THAT(refusal("--structure grid --split median"), contains_text("not an option of grid"));
    put_bytes(folder / "rays.csv", "origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,"
                                   "t_min,t_max\n0,0,5,0,0,-1,0,100\n");
    CHECK_THAT(refusal("--structure grid,kd_ropes --rays rays.csv --hits hits.csv"),
               contains_text("Name one."));
}

TEST_CASE("a walk that is wrong is named with those that it differs from", "[07][program][judge]") {
    const ScratchFolder folder("07_planted");
    // A copy of a walk that loses each hit whose number divides by 5.
    std::string walk = bytes_of(RAYSTEPS_SOURCE_DIR "/shaders/structure/bvh/bvh_skip.glsl");
    const std::string right = "    walk.nearest = nearest;\n";
    const std::size_t place = walk.find(right);
    REQUIRE(place != std::string::npos);
    walk.replace(place, right.size(),
                 "    walk.nearest = nearest;\n    if (nearest.triangle % 5 == 0) {\n"
                 "        walk.nearest = miss(ray);\n    }\n");
    std::filesystem::create_directories(folder / "shaders/structure/bvh");
    put_bytes(folder / "shaders/structure/bvh/bvh_skip.glsl", walk);
    const std::string options = "--scene compact:4 --embree off --rounds 1 --size 64 --structure ";
    const std::string planted = "RAYSTEPS_SHADERS='" + (folder / "shaders").string() + "'";
    CHECK(run_in(folder, options + "bvh_skip"));
    CHECK_FALSE(run_in(folder, options + "grid,bvh_skip", planted));
    const std::string errors = bytes_of(folder / "errors");
    CHECK_THAT(errors, contains_text("bvh_skip differs from the loop over every triangle"));
    CHECK_THAT(errors, contains_text("grid differs from bvh_skip"));
    CHECK(errors.find("grid differs from the loop") == std::string::npos);
    CHECK_THAT(bytes_of(folder / "output"), contains_text("Who differs from whom"));

    // Alone, nobody else is there to tell: the loop does.
    CHECK_FALSE(run_in(folder, options + "bvh_skip", planted));
    CHECK_THAT(bytes_of(folder / "errors"), contains_text("bvh_skip differs from the loop"));

    // The rays come back from their file, and the right walk answers as the loop did.
    CHECK(run_in(folder, "--scene compact:4 --structure bvh_skip --hits hits.csv --rays "
                         "out/07_compare/disputed_primary_rays.csv"));
    const std::string answers = bytes_of(folder / "out/07_compare/disputed_primary_answers.csv");
    std::istringstream hits(bytes_of(folder / "hits.csv"));
    std::string hit;
    std::getline(hits, hit); // the names
    for (int ray = 0; std::getline(hits, hit); ++ray) {
        CAPTURE(ray);
        CHECK_THAT(answers,
                   contains_text(std::to_string(ray) + ",the loop over every triangle," + hit));
    }
    CHECK_THAT(answers, contains_text("exact arithmetic"));
}

TEST_CASE("a run is compared with an earlier one and says what is slower",
          "[07][program][against]") {
    const ScratchFolder folder("07_against");
    const std::string options = "--scene compact:4 --structure bvh_skip,kd_ropes --rounds 5 "
                                "--size 16 --embree off ";
    REQUIRE(run_in(folder, options + "--json then.json"));
    auto then = nlohmann::json::parse(bytes_of(folder / "then.json"));
    // Far more than what a busy machine can do: the test does not depend on time.
    const auto with_rates_times = [&](double factor) {
        auto changed = then;
        for (auto& kind : changed["scenes"][0]["kinds"]) {
            for (auto& walk : kind["walks"]) {
                for (const std::string name :
                     {"million_rays_per_cpu_second", "lowest_by_cpu_time", "highest_by_cpu_time"}) {
                    walk[name] = walk[name].get<double>() * factor;
                }
            }
        }
        std::ofstream(folder / "changed.json") << changed;
        const bool done = run_in(folder, options + "--against changed.json");
        return std::pair{done, bytes_of(folder / "output")};
    };
    const auto [fine, faster] = with_rates_times(1e-6);
    CHECK(fine);
    CHECK_THAT(faster, contains_text("by processor time") && contains_text("faster beyond doubt"));
    const auto [passed, slower] = with_rates_times(1e6);
    CHECK_FALSE(passed);
    CHECK_THAT(slower, contains_text("slower beyond doubt"));
    CHECK_THAT(bytes_of(folder / "errors"), contains_text("8 of 8 rates are lower than then"));

    const auto refusal = [&](const nlohmann::json& file, const std::string& more = "") {
        std::ofstream(folder / "changed.json") << file;
        CHECK_FALSE(run_in(folder, options + more + " --against changed.json"));
        return bytes_of(folder / "errors");
    };
    auto old = then;
    old["head"]["schema_version"] = 0;
    CHECK_THAT(refusal(old), contains_text("changed.json: the file has version 0 of its schema"));
    old = then;
    old.erase("head");
    CHECK_THAT(refusal(old), contains_text("the file has no head"));
    CHECK_THAT(refusal(then, "--scenes knot"), contains_text("it has no scene knot"));
    old = then;
    old["head"]["scenes"][0]["hash"] = "0123456789abcdef";
    CHECK_THAT(refusal(old), contains_text("its scene compact:4 is another one"));
    old = then;
    old["head"]["cpu"] = "abacus";
    CHECK_THAT(refusal(old), contains_text("another machine (abacus"));
    CHECK_THAT(refusal(then, "--size 8"), contains_text("Add --size 16x16"));
    CHECK_THAT(refusal("no object"), contains_text("changed.json"));
}
