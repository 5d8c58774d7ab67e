#include "package_rules.h"

#include "source_tree.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {

// A package's headers, and where they may be included.
struct PackageRule {
    std::string header; // how the name begins
    std::vector<std::string> places;
};

const std::vector<PackageRule> package_rules{
    {"glad/", {"common/gpu/gl.h"}},
    {"GL/", {"common/gpu/context/osmesa.cpp"}},
    {"EGL/", {"common/gpu/context/egl.cpp", "visualizer/vtk/"}},
    {"GLFW/", {"common/gpu/context/window.cpp", "common/window/glfw/"}},
    {"tiny_obj_loader.h", {"common/scene/obj/load_obj.cpp"}},
    {"toml++/", {"common/scene/toml_"}},
    {"stb_", {"common/image/"}},
    {"CLI/", {"common/command/", "visualizer/request.cpp"}},
    {"nlohmann/",
     {"common/command/", "common/course/", "tests/", "visualizer/state_file.cpp",
      "visualizer/walk_file.cpp"}},
    {"vtk", {"visualizer/vtk/", "tests/drawing/"}},
    {"X11/", {"visualizer/vtk/"}},
    {"boost/", {"common/reference/", "tests/"}},
    {"embree3/", {"common/embree/there/"}},
    {"embree4/", {"common/embree/there/"}},
    {"rapidcheck", {"tests/"}},
    {"catch2/", {"tests/catch.h"}},
};

bool begins_with_any(const std::string& text, const std::vector<std::string>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string& beginning) { return text.starts_with(beginning); });
}

std::string scattered_package(const std::string& header, const PackageRule& rule) {
    return "<" + header + "> is for " + rule.places.front() + " to include.";
}

} // namespace

std::vector<std::string> find_scattered_packages(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& file :
         list_files(root, {"common", "chapters", "tests", "visualizer"}, {".h", ".cpp", ".inc"})) {
        for (const Include& include : includes_of(root / file)) {
            for (const PackageRule& rule : package_rules) {
                if (include.name.starts_with(rule.header) && !begins_with_any(file, rule.places)) {
                    faults.push_back(
                        fault_at(file, include.line, scattered_package(include.name, rule)));
                }
            }
        }
    }
    return faults;
}
