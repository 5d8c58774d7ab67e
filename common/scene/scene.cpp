#include "scene/scene.h"

#include <algorithm>
#include <filesystem>

namespace raysteps {

float transparency(const Material& material) {
    if (material.opacity < 1.0f) {
        return 1.0f - material.opacity;
    }
    const int model = material.illumination_model;
    return model == 4 || model == 6 || model == 7 || model == 9 ? 1.0f : 0.0f;
}

namespace {

std::string name_of(const Scene& scene, const NamedRun& run) {
    const std::filesystem::path path(scene.models[static_cast<std::size_t>(run.model)].path);
    std::string name = path.filename().string();
    if (!run.object.empty()) {
        name += ", object \"" + run.object + "\"";
    }
    if (run.primitive >= 0) {
        name += ", primitive " + std::to_string(run.primitive);
    }
    return name;
}

std::string range_text(int first, int last) {
    return first == last ? " " + std::to_string(first)
                         : "s " + std::to_string(first) + " to " + std::to_string(last);
}

} // namespace

std::string name_of_triangle(const Scene& scene, int triangle) {
    const auto next = std::upper_bound(
        scene.runs.begin(), scene.runs.end(), triangle,
        [](int number, const NamedRun& run) { return number < run.first_triangle; });
    if (next == scene.runs.begin() || triangle < 0 || triangle >= triangle_count(scene)) {
        return "";
    }
    const std::string name = name_of(scene, *std::prev(next));
    return scene.faces.empty()
               ? name
               : name + ", face " + std::to_string(scene.faces[static_cast<std::size_t>(triangle)]);
}

std::vector<std::string> describe_runs(const Scene& scene) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < scene.runs.size(); ++i) {
        const int first = scene.runs[i].first_triangle;
        const int end =
            i + 1 < scene.runs.size() ? scene.runs[i + 1].first_triangle : triangle_count(scene);
        if (first == end) {
            continue;
        }
        std::string line =
            "triangle" + range_text(first, end - 1) + ": " + name_of(scene, scene.runs[i]);
        if (!scene.faces.empty()) {
            const auto [least, greatest] =
                std::minmax_element(scene.faces.begin() + first, scene.faces.begin() + end);
            line += ", face" + range_text(*least, *greatest);
        }
        lines.push_back(line);
    }
    return lines;
}

} // namespace raysteps
