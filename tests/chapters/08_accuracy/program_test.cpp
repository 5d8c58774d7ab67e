#include "08_accuracy/scene_needs.h"
#include "catch.h"
#include "scene/shapes.h"
#include "support/scene_of.h"
#include "support/scratch_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sys/wait.h>

using namespace raysteps;

namespace {

int run(const std::string& arguments, const ScratchFolder& folder) {
    const std::string command = std::string("'") + PROGRAM_08_ACCURACY + "' " + arguments +
                                " --out '" + (folder / "").string() + "' >'" +
                                (folder / "log").string() + "' 2>&1";
    const int status = std::system(command.c_str()); // NOLINT(cert-env33-c): the words are ours
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

TEST_CASE("a sphere is closed and a quad is not", "[08][needs]") {
    const SceneNeeds ball = find_needs(scene_of(sphere({0, 0, 0}, 1.0f, 3)));
    CHECK(ball.triangles == 180);
    CHECK(ball.open_edges == 0);
    CHECK(ball.slivers == 0);
    CHECK(ball.without_area == 0);
    CHECK(ball.small_for_the_paper == 0);
    const SceneNeeds flat = find_needs(scene_of(quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})));
    CHECK(flat.open_edges == 4);
    CHECK(flat.smallest_edge == 1.0);
    CHECK(flat.thinnest == Approx(2.0)); // sqrt(2) squared, over twice the area
}

TEST_CASE("slivers and small triangles and far ones are found", "[08][needs]") {
    const SceneNeeds thin = find_needs(scene_of(triangle({0, 0, 0}, {1, 0, 0}, {0.5f, 1e-4f, 0})));
    CHECK(thin.slivers == 1);
    CHECK(thin.thinnest == Approx(1e4).epsilon(1e-3));
    const SceneNeeds small = find_needs(
        scene_of(triangle({0, 0, 0}, {0.0005f, 0, 0}, {0, 0.0005f, 0}))); // 2.5e-7 < 1e-6
    CHECK(small.small_for_the_paper == 1);
    const float far = 65536.0f;
    const SceneNeeds away = find_needs(scene_of(triangle({far, 0, 0}, {far, 1, 0}, {far, 0, 1})));
    CHECK(away.digits_left == Approx(8.0)); // 24 digits, 16 of them before the point
    CHECK(find_needs(Scene{}).triangles == 0);
    CHECK(to_sentences(find_needs(Scene{})).size() == 1);
}

TEST_CASE("the program writes page and table and numbers for a scene of ones own",
          "[08][program]") {
    const ScratchFolder folder("accuracy_program");
    put_bytes(folder / "wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    REQUIRE(run("--scene '" + (folder / "wedge.obj").string() +
                    "' --trade-offs triangle,slab --rounds 1 --context osmesa",
                folder) == 0);
    const nlohmann::json numbers = nlohmann::json::parse(bytes_of(folder / "accuracy.json"));
    REQUIRE(numbers["trade_offs"].size() == 2);
    CHECK(numbers["trade_offs"][0]["measurements"].size() == 8 * 11);
    CHECK(numbers["trade_offs"][0]["methods"].size() == 11);
    CHECK(numbers["head"]["scenes"][0]["scene"] == "wedge");
    std::set<std::string> needs;
    for (const auto& advice : numbers["advice"]) {
        needs.insert(advice["need"]);
    }
    CHECK(needs == std::set<std::string>{"preview", "default", "closed mesh", "reference"});
    const std::string page = bytes_of(folder / "accuracy.html");
    CHECK_THAT(page, contains_text("The mesh is closed"));
    CHECK_THAT(page, contains_text("<svg"));
    CHECK(page.find("http") == std::string::npos); // needs no network
    const std::string csv = bytes_of(folder / "accuracy.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 8 * 11 + 6 * 4);
}

TEST_CASE("a scene without a triangle has a report too", "[08][program]") {
    const ScratchFolder folder("accuracy_nothing");
    put_bytes(folder / "nothing.obj", "v 0 0 0\n");
    CHECK(run("--scene '" + (folder / "nothing.obj").string() +
                  "' --trade-offs picture,speed --rounds 1 --size 16 --context osmesa",
              folder) == 0);
    CHECK_THAT(bytes_of(folder / "accuracy.html"), contains_text("any method will do"));
}

TEST_CASE("the pictures of a report are files that its numbers name", "[08][program]") {
    const ScratchFolder folder("accuracy_pictures");
    REQUIRE(run("--knobs depth --rounds 1 --size 16 --context osmesa", folder) ==
            0); // its old name
    const nlohmann::json numbers = nlohmann::json::parse(bytes_of(folder / "accuracy.json"));
    const nlohmann::json pictures = numbers["trade_offs"][0]["pictures"];
    CHECK(pictures.size() == 7);
    for (const auto& picture : pictures) {
        CHECK(bytes_of(folder / picture["file"].get<std::string>()).substr(1, 3) == "PNG");
    }
    CHECK_THAT(bytes_of(folder / "accuracy.html"), contains_text("data:image/png;base64,iVBOR"));
}

TEST_CASE("without Python the report says what is missing and keeps its numbers", "[08][program]") {
    const ScratchFolder folder("accuracy_no_python");
    const std::string command =
        "PATH=/nowhere '" PROGRAM_08_ACCURACY "' --trade-offs slab --rounds 1 "
        "--context osmesa --out '" +
        (folder / "").string() + "' >'" + (folder / "log").string() + "' 2>&1";
    const int status = std::system(command.c_str()); // NOLINT(cert-env33-c): the words are ours
    CHECK(WEXITSTATUS(status) == 3);
    CHECK_THAT(bytes_of(folder / "log"), contains_text("accuracy.html: python3 is missing"));
    CHECK(std::filesystem::exists(folder / "accuracy.json"));
}

TEST_CASE("what cannot be reported is refused in a sentence", "[08][program]") {
    const ScratchFolder folder("accuracy_refusals");
    CHECK(run("--trade-offs nonsense --context osmesa", folder) == 2);
    CHECK_THAT(bytes_of(folder / "log"), contains_text("--trade-offs nonsense: there is no such"));
    CHECK(run("--window", folder) == 2);
    CHECK_THAT(bytes_of(folder / "log"), contains_text("open accuracy.html in a browser"));
    CHECK(run("--json /dev/null", folder) == 2); // before any work
    CHECK_THAT(bytes_of(folder / "log"), contains_text("/dev/null: "));
    CHECK(run("--quick --full", folder) == 2);
    CHECK(run("--rounds 0", folder) == 2);
}
