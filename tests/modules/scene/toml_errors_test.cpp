#include "basics/error.h"
#include "catch.h"
#include "scene/load_scene.h"
#include "scene_tests.h"

#include <filesystem>
#include <fstream>

using namespace raysteps;

namespace {

struct Fault {
    std::string text;
    std::string place; // line and column
    std::string words; // that the sentence has, the key among them
};

std::string complaint_about_text(const std::string& text) {
    try {
        read_toml_scene(text, scene_files / "scene.toml", 1.0f);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

void check(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) {
        CAPTURE(fault.text);
        const std::string complaint = complaint_about_text(fault.text);
        CAPTURE(complaint);
        const std::string place = (scene_files / "scene.toml").string() + ":" + fault.place + ": ";
        REQUIRE(complaint.starts_with(place));
        REQUIRE(complaint.find(fault.words) != std::string::npos);
        REQUIRE(complaint.ends_with("."));
    }
}

const std::string sample = "sample = 'compact:1'\n";
const std::string model = "[[model]]\npath = 'pyramid.obj'\n";
const std::string camera = sample + "[camera]\neye = [0, 0, 5]\n"; // target comes in line 4

} // namespace

TEST_CASE("text that is no TOML is refused with line and column", "[scene][toml]") {
    check({
        {"sample = \n", "1:10", "value"},
        {sample + "[camera\n", "2:8", "]"},
        {sample + sample, "2:10", "sample"},
        {sample + "\x01", "2:1", ""},
        {sample + "background = [1, 2, \xff\xfe]", "2:20", "utf-8"},
    });
}

TEST_CASE("unknown keys are refused by name", "[scene][toml]") {
    check({
        {sample + "ligth = []\n", "2:1", "\"ligth\". Did you mean light?"},
        {sample + "[camera]\nfov = 3\n", "3:1", "camera has no key \"fov\""},
        {sample + "[[light]]\nposition = [1, 2, 3]\ncolour = [1, 1, 1]\n", "4:1",
         "\"colour\". Did you mean color?"},
        {model + "rotation = 3\n", "3:1", "model has no key \"rotation\""},
        {model + "rotate = { axis = [0, 1, 0], degrees = 3, radians = 1 }\n", "3:43",
         "\"radians\""},
    });
}

TEST_CASE("numbers that are malformed, not finite or out of range are refused", "[scene][toml]") {
    check({
        {camera + "target = [0, nan, 0]\n", "4:14", "target is nan"},
        {camera + "target = [0, 0, inf]\n", "4:17", "target is inf"},
        {camera + "target = [0, -1e19, 0]\n", "4:14", "target is -1e+19"},
        {camera + "target = [0, '0', 0]\n", "4:14", "target must be a number"},
        {camera + "target = [0, 0]\n", "4:10", "target must be an array of 3 numbers"},
        {camera + "target = 7\n", "4:10", "target must be an array of 3 numbers"},
        {sample + "background = [0, -0.1, 0]\n", "2:18", "background is -0.1"},
        {sample + "background = [0, 1e7, 0]\n", "2:18", "background is 1e+07"},
        {sample + "[[light]]\nposition = [9e18, 0, 0]\n", "3:13", "position is 9e+18"},
        {sample + "[[light]]\nposition = [9, 0, 0]\ncolor = [1, 1, -1]\n", "4:16", "color is -1"},
        {model + "translate = [9223372036854775807, 0, 0]\n", "3:14",
         "translate is 9223372036854775808"},
        {model + "scale = 'big'\n", "3:9", "scale must be a number or an array"},
        {model + "scale = inf\n", "3:9", "scale is inf"},
    });
}

TEST_CASE("a camera that sees nothing is refused", "[scene][toml]") {
    check({
        {camera + "target = [0, 0, 5]\n", "2:1", "eye and target are the same point"},
        {camera + "target = [0, 0, 0]\nup = [0, 0, -2]\n", "5:6", "up is parallel"},
        {camera + "target = [0, 0, 0]\nup = [0, 0.004, -8]\n", "5:6", "up is parallel"},
        {camera + "target = [0, 9, 5]\n", "2:1", "up is parallel"},
        {camera + "target = [0, 0, 0]\nup = [0, 0, 0]\n", "5:6", "up must not be"},
        {camera + "target = [0, 0, 0]\nvertical_field_of_view = 0\n", "5:26", "over 0"},
        {camera + "target = [0, 0, 0]\nvertical_field_of_view = 180\n", "5:26", "under 180"},
        {camera + "target = [0, 0, 0]\nvertical_field_of_view = 179.9999999\n", "5:26",
         "under 180"},
        {camera + "target = [0, 0, 0]\nvertical_field_of_view = -1\n", "5:26", "between 0 and 180"},
        {camera, "2:1", "camera needs a target"},
        {sample + "[camera]\ntarget = [0, 0, 0]\n", "2:1", "camera needs an eye"},
        {"camera = 3\n" + sample, "1:10", "camera must be a table"},
    });
}

TEST_CASE("lights that are none are refused", "[scene][toml]") {
    check({
        {sample + "light = 3\n", "2:9", "light must be an array"},
        {sample + "light = [3]\n", "2:10", "light must be a table"},
        {sample + "[[light]]\ncolor = [1, 1, 1]\n", "2:1", "a light needs a position"},
    });
}

TEST_CASE("models that are none are refused", "[scene][toml]") {
    check({
        {"model = []\n", "1:9", "at least one file"},
        {"model = 'a.obj'\n", "1:9", "model must be an array"},
        {"[[model]]\nscale = 2\n", "1:1", "a model needs the path"},
        {"[[model]]\npath = 3\n", "2:8", "path must be a text"},
        {"[[model]]\npath = 'lost.obj'\n", "2:8", "there is no file \"lost.obj\""},
        {"[[model]]\npath = '.'\n", "2:8", "there is no file \".\""},
        {"[[model]]\npath = ''\n", "2:8", "there is no file \"\""},
        {"[[model]]\npath = '/dev/zero'\n", "2:8", "there is no file \"/dev/zero\""},
        {"[[model]]\npath = \"a\\u0000b\"\n", "2:8", "there is no file"},
        {sample + model, "1:10", "sample and model exclude each other"},
        {"name = 'x'\n" + sample, "1:8", "a sample has its own name"},
        {"sample = 'compact:0'\n", "1:10", "SIZE is a whole number from 1 to 400"},
        {"sample = 'teapot'\n", "1:10", "There is no scene \"teapot\""},
    });
}

TEST_CASE("transforms that flatten or overflow are refused", "[scene][toml]") {
    check({
        {model + "scale = 0\n", "1:1", "flattens"},
        {model + "scale = [1, 0, 1]\n", "1:1", "flattens"},
        {model + "scale = 1e-60\n", "1:1", "flattens"},
        {model + "matrix = [1,2,3,0, 2,4,6,0, 0,0,1,0, 0,0,0,1]\n", "1:1", "flattens"},
        {model + "matrix = [0.1,0.3,0.4,0, 0.2,0.6,0.8,0, 0,0.7,1,0, 0,0,0,1]\n", "1:1",
         "flattens"},
        {model + "matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]\n", "3:10", "last row"},
        {model + "matrix = [1,0,0,0]\n", "3:10", "16 numbers"},
        {model + "matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]\nscale = 2\n", "4:9",
         "scale and matrix exclude each other"},
        {model + "scale = 1e18\ntranslate = [1e18, 0, 0]\n", "1:1", "beyond 1.8e18"},
        {model + "rotate = 90\n", "3:10", "rotate must be a table"},
        {model + "rotate = { axis = [0, 1, 0] }\n", "3:10", "rotate needs both"},
        {model + "rotate = { axis = [0, 0, 0], degrees = 3 }\n", "3:19", "axis must not be"},
    });
}

TEST_CASE("a thin but not flat transform is taken", "[scene][toml]") {
    REQUIRE(complaint_about_text(model + "scale = [1, 1e-9, 1]\n") == "none");
    REQUIRE(complaint_about_text(model + "scale = 1e-12\n") == "none");
}

TEST_CASE("a file that names no scene is refused", "[scene][toml]") {
    const std::string words = "the file names no scene";
    REQUIRE(complaint_about_text("").find(words) != std::string::npos);
    REQUIRE(complaint_about_text("background = [0, 0, 0]\n").find(words) != std::string::npos);
}

TEST_CASE("a fault in a model is reported with the place in the model's file", "[scene][toml]") {
    const std::filesystem::path path =
        std::filesystem::path(RAYSTEPS_BINARY_DIR) / "broken_model.obj";
    std::ofstream(path) << "v 0 0 0\nv 1 0 0\nf 1 2 99999\n";
    const std::string complaint =
        complaint_about_text("[[model]]\npath = '" + path.string() + "'\n");
    REQUIRE(complaint.find("broken_model.obj:3") != std::string::npos);
}

TEST_CASE("a scene file that is too large is not read", "[scene][toml]") {
    const std::filesystem::path path =
        std::filesystem::path(RAYSTEPS_BINARY_DIR) / "too_large.toml";
    std::ofstream(path) << std::string((1u << 20) + 1, '#');
    REQUIRE_THROWS_AS(load_scene(path.string(), 1.0f), InputError);
    REQUIRE_THROWS_AS(load_scene("/dev/zero/x.toml", 1.0f), InputError);
}

TEST_CASE("deeply nested text is refused instead of exhausting the stack", "[scene][toml]") {
    const std::string text = "sample = " + std::string(100'000, '[');
    REQUIRE(complaint_about_text(text).find("scene.toml:1:") != std::string::npos);
}
