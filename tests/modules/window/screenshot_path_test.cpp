#include "program/window/screen.h"

#include "catch.h"

#include <fstream>

using namespace raysteps;

TEST_CASE("a screenshot takes the first free number", "[window]") {
    const std::filesystem::path folder =
        std::filesystem::path(RAYSTEPS_BINARY_DIR) / "tests/window/screenshot_path";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::filesystem::path name = folder / "scene.v2";
    CHECK(screenshot_path(name) == folder / "scene.v2-1.png");
    std::ofstream(folder / "scene.v2-1.png") << "taken";
    std::ofstream(folder / "scene.v2-3.png") << "taken";
    CHECK(screenshot_path(name) == folder / "scene.v2-2.png");
    std::filesystem::create_symlink("nowhere", folder / "scene.v2-2.png");
    CHECK(screenshot_path(name) == folder / "scene.v2-4.png");
    std::filesystem::remove_all(folder);
    CHECK(screenshot_path(name) == folder / "scene.v2-1.png");
}
