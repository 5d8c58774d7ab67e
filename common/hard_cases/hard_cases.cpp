#include "hard_cases/hard_cases.h"

#include "basics/error.h"
#include "basics/text.h"
#include "hard_cases/case_lists.h"
#include "scene/frame_scene.h"

#include <algorithm>
#include <cctype>

namespace raysteps {

namespace {

std::vector<HardCase> join_lists() {
    std::vector<HardCase> all;
    for (const auto list :
         {paper_cases, triangle_cases, grid_cases, kd_cases, tree_cases, determinism_cases}) {
        for (HardCase& hard_case : list()) {
            all.push_back(std::move(hard_case));
        }
    }
    return all;
}

bool is_same_name(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::toupper(x) == std::toupper(y);
    });
}

} // namespace

const std::vector<HardCase>& hard_cases() {
    static const std::vector<HardCase> all = join_lists();
    return all;
}

const HardCase& find_hard_case(const std::string& name) {
    std::vector<std::string_view> names;
    for (const HardCase& hard_case : hard_cases()) {
        if (is_same_name(hard_case.name, name)) {
            return hard_case;
        }
        names.emplace_back(hard_case.name);
    }
    throw InputError(no_such_choice("", name, "hard case with a mesh and rays", names));
}

Scene scene_of(const HardCase& hard_case, const HardScene& made, float aspect_ratio) {
    Scene scene = add_mesh(Scene{}, made.mesh, Material{});
    scene.name = "hard case " + hard_case.name;
    return frame_scene(std::move(scene), aspect_ratio);
}

} // namespace raysteps
