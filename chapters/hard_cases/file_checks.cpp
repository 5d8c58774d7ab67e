#include "basics/error.h"
#include "hard_cases/file_cases.h"
#include "scene/obj/load_obj.h"
#include "checks.h"

#include <cmath>

namespace raysteps {

namespace {

struct Outcome {
    int triangles = -1; // below 0: refused
    std::string words;
};

template <class Load>
Outcome outcome_of(const Load& load) {
    try {
        const Scene scene = load();
        Outcome outcome{triangle_count(scene), ""};
        for (const std::string& message : scene.messages) {
            outcome.words += message + "\n";
        }
        return outcome;
    } catch (const InputError& error) {
        return {-1, error.what()};
    }
}

std::string to_words(int triangles) {
    return triangles < 0 ? "refused" : std::to_string(triangles) + " triangles";
}

TrialRow load_row(const FileCase& file, const Outcome& outcome) {
    const bool right =
        outcome.triangles == file.triangles && outcome.words.find(file.says) != std::string::npos;
    const bool unsaid = outcome.triangles == file.triangles && !right;
    return {"load_obj",
            "",
            to_words(file.triangles),
            to_words(outcome.triangles) + (unsaid ? ", without a word of it" : ""),
            right ? Verdict::pass : Verdict::fail,
            1,
            right ? std::size_t{0} : std::size_t{1}};
}

std::vector<TrialRow> folder_and_device(const TrialTools&) {
    std::vector<TrialRow> rows;
    for (const auto& [path, says] : {std::pair{"/", "is a folder"}, {"/dev/zero", "is a device"}}) {
        rows.push_back(
            load_row({"", "", "", -1, says}, outcome_of([from = path] { return load_obj(from); })));
    }
    return rows;
}

std::vector<TrialRow> impossible_materials(const TrialTools&) {
    std::size_t wrong = 1;
    for (const Material& material :
         parse_mtl(mtl_of_impossible_values(), "impossible.mtl", ".").materials) {
        const bool right = glm::all(glm::greaterThanEqual(material.diffuse, glm::vec3(0.0f))) &&
                           glm::all(glm::lessThanEqual(material.diffuse, glm::vec3(1.0f))) &&
                           glm::all(glm::lessThanEqual(material.specular, glm::vec3(1.0f))) &&
                           std::isfinite(material.shininess) && material.refractive_index > 0.0f &&
                           material.opacity <= 1.0f && material.opacity >= 0.0f;
        wrong = right ? 0 : 1;
    }
    return {promised_row("parse_mtl", "", "values in their ranges", wrong, 1)};
}

} // namespace

std::vector<Trial> file_checks() {
    std::vector<Trial> trials;
    for (const FileCase& file : file_cases()) {
        trials.push_back(
            {file.name, file.title, "", "check the export", [file](const TrialTools&) {
                 return std::vector<TrialRow>{
                     load_row(file, outcome_of([&] { return parse_obj(file.text, "model.obj"); }))};
             }});
    }
    trials.push_back(
        {"F19", "a folder and a device in place of a file", "", "name a file", folder_and_device});
    trials.push_back({"E5", "materials with Ni = 0, Ns = inf, a negative Kd and d over 1", "",
                      "check the export", impossible_materials});
    return trials;
}

} // namespace raysteps
