#include "catch.h"
#include "support/scratch_folder.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <set>

namespace {

// Runs the program in the folder. True where it ends well.
bool run_in(const ScratchFolder& folder, const std::string& options) {
    const std::string line = "cd '" + (folder / "").string() +
                             "' && env -u DISPLAY -u WAYLAND_DISPLAY timeout 90 '" +
                             PROGRAM_10_SPEED "' " + options + " >output 2>errors </dev/null";
    return std::system(line.c_str()) == 0; // NOLINT(cert-env33-c): every word is ours
}

const std::set<std::string> for_neighbours{"skip, in rows", "skip, in blocks", "ordered",
                                           "four boxes", "four rays"};

} // namespace

TEST_CASE("the climb has every step of every kind of rays, in the scenes that were named",
          "[10][program]") {
    const ScratchFolder folder("10_climb");
    REQUIRE(run_in(folder, "--scenes compact:4,cornell_box --size 24x20 --rounds 1 --json c.json"));
    const auto figures = nlohmann::json::parse(bytes_of(folder / "c.json"));
    const bool embree = figures["embree"] != "";
    CHECK(figures["yardstick"] == (embree ? "Embree rtcIntersect1" : "skip, in rows"));
    CHECK(figures["head"]["schema"] == "climb.schema.json");
    REQUIRE(figures["scenes"].size() == 2);
    CHECK(figures["scenes"][1]["scene"] == "cornell_box");
    for (const auto& scene : figures["scenes"]) {
        REQUIRE(scene["kinds"].size() == 3);
        for (const auto& kind : scene["kinds"]) {
            CAPTURE(scene["scene"], kind["kind"]);
            std::set<std::string> expected = for_neighbours;
            if (kind["kind"] == "bounce") {
                expected.erase("four rays");
            }
            std::set<std::string> found;
            for (const auto& step : kind["steps"]) {
                found.insert(step["step"].get<std::string>());
                CHECK(step["ratio"]["median"] > 0.0);
                CHECK(step.contains("lanes_at_work") == (step["step"] != "four rays"));
            }
            CHECK(found == expected);
            // In both layouts the same rays make the same walk, and none of a part of its own.
            CHECK(kind["steps"][0]["visits_per_ray"] == kind["steps"][1]["visits_per_ray"]);
            CHECK(kind["steps"][0]["tests_per_ray"] == kind["steps"][1]["tests_per_ray"]);
        }
        CHECK(scene["kinds"][0]["kind"] == "primary");
        CHECK(scene["kinds"][0]["rays"] == 24 * 20);
    }
    for (const std::string file : {"climb.png", "climb.gp", "lanes.png", "rounds.png"}) {
        CHECK(std::filesystem::exists(folder / ("out/10_speed/" + file)));
    }
    CHECK_THAT(bytes_of(folder / "output"), contains_text("as the step before"));
}

TEST_CASE("without Embree the first step is the yardstick", "[10][program]") {
    const ScratchFolder folder("10_alone");
    REQUIRE(run_in(folder, "--scene compact:4 --size 16 --rounds 1 --embree off --json c.json"));
    const auto figures = nlohmann::json::parse(bytes_of(folder / "c.json"));
    CHECK(figures["yardstick"] == "skip, in rows");
    for (const auto& kind : figures["scenes"][0]["kinds"]) {
        CHECK(kind["steps"][0]["ratio"]["median"] == 1.0);
    }
}
