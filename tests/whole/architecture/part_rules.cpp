#include "rules.h"

#include "source_tree.h"

#include <algorithm>
#include <regex>

namespace fs = std::filesystem;

namespace {

// What must not stand in the parts of some folders; of all folders where none is named.
struct PartRule {
    std::regex form;
    std::string sentence;
    std::vector<std::string> folders;
};

const std::vector<PartRule>& part_rules() {
    // The folders that the mirror compiles as C++.
    static const std::vector<std::string> mirrored{"core", "triangle", "structure", "observer",
                                                   "light"};
    static const std::vector<PartRule> rules{
        {std::regex(R"(\blayout\s*\()"), "layout(...) is for passes.", {}},
        {std::regex(R"(\bgl_)"), "gl_* is for passes.", {}},
        {std::regex(R"(\b(?:in)?out\b)"), "no output parameters: return a struct.", {}},
        {std::regex(R"(\binline\b)"), "`inline` is no GLSL.", {}},
        {std::regex(R"(#\s*version\b)"), "#version is for passes.", {}},
        {std::regex(R"(\bdiscard\b)"), "discard is for passes: a part is pure.", {}},
        {std::regex(R"(\.(?:[xyzw]{2,4}|[rgba]{2,4}|[stpq]{2,4})\b)"),
         "a swizzle is no C++. Write vec3(v), or name the components one by one.", mirrored},
        {std::regex(R"(#\s*include\b)"), "a part of core includes nothing.", {"core"}},
    };
    return rules;
}

bool applies(const PartRule& rule, const std::string& file) {
    return rule.folders.empty() ||
           std::any_of(rule.folders.begin(), rule.folders.end(), [&](const std::string& folder) {
               return file.starts_with("shaders/" + folder + "/");
           });
}

} // namespace

std::vector<std::string> find_faults_of_parts(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, {"shaders"}, {".glsl"})) {
        int number = 0;
        for (const std::string& line : code_lines(root / file)) {
            ++number;
            for (const PartRule& rule : part_rules()) {
                if (applies(rule, file) && std::regex_search(line, rule.form)) {
                    faults.push_back(fault_at(file, number, rule.sentence));
                }
            }
        }
    }
    return faults;
}

std::vector<std::string> find_faults_of_passes(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, {"shaders"}, {".frag", ".vert"})) {
        const std::vector<std::string> lines = code_lines(root / file);
        if (lines.empty() || lines.front() != "#version 410 core") {
            faults.push_back(fault_at(file, 1, "a pass begins with `#version 410 core`."));
        }
        if (!file.starts_with("shaders/pass/")) {
            faults.push_back(fault_at(file, 1, "passes are in shaders/pass."));
        }
    }
    return faults;
}
