#include "basics/error.h"
#include "scene/obj/load_obj.h"
#include "trials.h"

#include <cmath>

namespace raysteps {

namespace {

// An OBJ file that tempts a loader, and what an honest one makes of it.
struct FileCase {
    std::string name;  // F1
    std::string title; // what is wrong, in one sentence
    std::string text;
    int triangles = -1; // of the scene; below 0: the file is refused
    std::string says;   // words of the sentence that it is refused with, or of a message
};

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string polygon(int sides) {
    std::string text;
    std::string face = "f";
    for (int i = 0; i < sides; ++i) { // on a parabola, so convex, in whole numbers
        text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    return text + face + "\n";
}

std::vector<FileCase> file_cases() {
    const std::string no_number = "is not a number";
    return {
        {"F1", "nan as text", corners + "v nan 0 0\nf 1 2 3\n", -1, no_number},
        {"F2", "inf as text", "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n", -1, no_number},
        {"F3", "1e39, which is too large for a float", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n",
         -1, no_number},
        {"F4", "a number whose square overflows a float",
         "v 0 0 0\nv -1.9e18 0 0\nv 0 1 0\nf 1 2 3\n", -1, no_number},
        {"F5", "an index that would wrap to the first vertex", corners + "f 4294967297 2 3\n", -1,
         "4294967297"},
        {"F6", "an index out of range", corners + "f 1 2 99999\n", -1, "names vertex 99999"},
        {"F7", "an index that counts back too far", corners + "f -1 -2 -4\n", -1,
         "names vertex -4"},
        {"F8", "an index of zero", corners + "f 0 1 2\n", -1, "\"0\""},
        {"F9", "statements in capitals", "V 0 0 0\nF 1 2 3\n", 0, "no statement \"V\""},
        {"F10", "a byte order mark", "\xef\xbb\xbf" + corners + "f 1 2 3\n", 1, ""},
        {"F11", "a concave quadrilateral, from each of its corners",
         "v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 3 4 1\nf 3 4 1 2\nf 4 1 2 3\n", 8,
         ""},
        {"F12", "a polygon of 256 corners", polygon(256), 254, ""},
        {"F13", "a polygon of 20,000 corners", polygon(20000), 19998, ""},
        {"F14", "faces without area: dropped where two corners are one, else kept",
         corners + "v 2 0 0\nf 1 2 4\nf 1 1 1\nf 1 2 2\nf 1 2 3\n", 2,
         "fewer than three different corners"},
        {"F15", "a library outside the model's folder",
         "mtllib ../../dev/zero\nmtllib /dev/zero\n" + corners + "f 1 2 3\n", 1, "/dev/zero"},
        {"F16", "no triangle at all", corners, 0, ""},
        {"F17", "no text at all: a zero byte", std::string("v 0 0 0\n\0", 9), -1, "zero byte"},
        {"F18", "no statement at all", "", 0, ""},
    };
}

// An MTL file with values that no material has: Ni = 0, a negative Kd, an infinite Ns, d over 1.
std::string mtl_of_impossible_values() {
    return "newmtl impossible\nNi 0\nKd -1 2 nan\nKs inf 0 0\nNs inf\nd 7\nTf -1 0 0\nillum 99\n";
}

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
