#include "basics/error.h"
#include "basics/text.h"
#include "catch.h"
#include "scene/load_model.h"
#include "scene/load_scene.h"

#include <string>

using namespace raysteps;

namespace {

std::string complaint_about(const std::string& name) {
    try {
        load_scene(name, 1.0f);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

} // namespace

TEST_CASE("a parameter out of its range is refused with the range", "[scene]") {
    const std::string range = "sphereflake:DEPTH: DEPTH is a whole number from 0 to 5, not ";
    REQUIRE(complaint_about("sphereflake:6") == range + "\"6\".");
    REQUIRE(complaint_about("sphereflake:-1") == range + "\"-1\".");
    REQUIRE(complaint_about("sphereflake:99999999999999999999") ==
            range + "\"99999999999999999999\".");
}

TEST_CASE("a parameter that is no whole number is refused", "[scene]") {
    for (const std::string text : {"", "x", "2x", "2.5", " 2", "+2", "0x2", "nan"}) {
        CAPTURE(text);
        std::string expected = "knot:SIZE: SIZE is a whole number from 1 to 64, not \"";
        expected += text + "\".";
        REQUIRE(complaint_about("knot:" + text) == expected);
    }
}

TEST_CASE("too many parameters are refused", "[scene]") {
    REQUIRE(complaint_about("soup:10:1:2") ==
            "\"soup:10:1:2\" has 3 parameters, but the scene takes 2. Write soup:COUNT:SEED.");
    REQUIRE(complaint_about("mirrors:") ==
            "\"mirrors:\" has 1 parameters, but the scene takes 0. Write mirrors.");
}

TEST_CASE("an unknown name is refused with the nearest known one", "[scene]") {
    const std::string advice = "Give a model file, such as one that ends in .obj, .ply, .stl or "
                               ".glb, a .toml file, or a name that --list-scenes shows.";
    REQUIRE(complaint_about("sphere_flake:3") ==
            "There is no scene \"sphere_flake\". Did you mean sphereflake? " + advice);
    REQUIRE(complaint_about("cornell-box") ==
            "There is no scene \"cornell-box\". Did you mean cornell_box? " + advice);
    REQUIRE(complaint_about("teapot") == "There is no scene \"teapot\". " + advice);
    REQUIRE(complaint_about("") == "There is no scene \"\". " + advice);
    REQUIRE(complaint_about(":::") == "There is no scene \"\". " + advice);
}

TEST_CASE("a file of another kind is refused", "[scene]") {
    const std::string path = std::string(RAYSTEPS_SOURCE_DIR) + "/tests/CMakeLists.txt";
    REQUIRE(complaint_about(path) ==
            path + ": this is not a scene file. Give a file that ends in " + scene_endings() + ".");
    const std::string folder = RAYSTEPS_SOURCE_DIR "/tests/modules/scene";
    REQUIRE(complaint_about(folder) ==
            folder + ": this is a folder. Give a file that ends in " + scene_endings() + ".");
}

TEST_CASE("a file that does not exist is refused with its path", "[scene]") {
    REQUIRE(complaint_about("nowhere/lost.obj").find("nowhere/lost.obj") != std::string::npos);
    REQUIRE(complaint_about("nowhere/lost.TOML").find("nowhere/lost.TOML") != std::string::npos);
}

TEST_CASE("the nearest word is found by letters added or removed or changed", "[scene]") {
    const std::vector<std::string_view> words = {"camera", "light", "model"};
    REQUIRE(nearest_word("camera", words) == "camera");
    REQUIRE(nearest_word("lights", words) == "light");
    REQUIRE(nearest_word("ligth", words) == "light");
    REQUIRE(nearest_word("lightss", words) == "light");
    REQUIRE(nearest_word("mdel", words) == "model");
    REQUIRE(nearest_word("mdl", words) == "model");
    REQUIRE(nearest_word("radiosity", words).empty());
    REQUIRE(nearest_word("", words).empty());
}
