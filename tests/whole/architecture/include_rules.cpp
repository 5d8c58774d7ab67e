#include "rules.h"

#include "source_tree.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace {

std::string first_folder(const std::string& path) {
    return path.substr(0, path.find('/'));
}

// common/scene/scene.h belongs to scene; empty for a file outside of common.
std::string module_of(const std::string& file) {
    const bool in_common = first_folder(file) == "common";
    return in_common ? first_folder(file.substr(std::string("common/").size())) : "";
}

// chapters/check of chapters/check/python/module.cpp.
std::string chapter_of(const std::string& file) {
    return file.substr(0, file.find('/', file.find('/') + 1));
}

std::vector<std::string> uses_of(const fs::path& root, const std::string& module) {
    return words_of_call(root / "common" / module / "CMakeLists.txt", "add_module", "USES");
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// Why `from` may not include `to`; empty where it may.
std::string objection(const std::string& from, const std::string& to) {
    const std::string fact = "includes " + to + ": ";
    const std::string origin = first_folder(from);
    const std::string target = first_folder(to);
    if (origin == "tests" || target == origin) {
        const bool other_chapter = origin == "chapters" && chapter_of(from) != chapter_of(to);
        return other_chapter ? fact + "a chapter includes nothing of another." : "";
    }
    if (origin == "visualizer" && (module_of(to) == "gpu" || module_of(to) == "render")) {
        return fact + "VTK and the renderer's OpenGL must not meet in one process.";
    }
    if (target == "shaders") {
        static const std::vector<std::string> bilingual{"basics", "structure", "mirror"};
        return contains(bilingual, module_of(from))
                   ? ""
                   : fact + "shaders are C++ only in common/basics, structure and mirror.";
    }
    if (target != "common") {
        return fact + "nothing includes " + target + "/ but " + target + "/ itself and tests.";
    }
    return "";
}

// The words of a row's last cell, up to what the module never includes.
std::set<std::string> modules_in(const std::string& cell) {
    std::istringstream words(
        std::regex_replace(cell.substr(0, cell.find(';')), std::regex(","), " "));
    std::set<std::string> allowed;
    std::string word;
    while (words >> word) {
        allowed.insert(word);
    }
    return allowed;
}

// What each row `| common/NAME | what it is | may include |` of the table of modules allows.
std::map<std::string, std::set<std::string>> read_table(std::istream& document) {
    static const std::regex row(R"(^\| common/(\w+) \|[^|]*\|([^|]*)\|\s*$)");
    std::map<std::string, std::set<std::string>> table;
    std::string line;
    while (std::getline(document, line)) {
        std::smatch match;
        if (std::regex_match(line, match, row)) {
            table[match[1]] = modules_in(match[2]);
        }
    }
    return table;
}

std::string undeclared_use(const std::string& module, const std::string& used) {
    return module + " includes " + used + ", but its add_module does not name it in USES.";
}

std::string dead_use(const std::string& module, const std::string& used) {
    return "common/" + module + "/CMakeLists.txt: USES names " + used + ", which no file of " +
           module + " includes.";
}

std::string unknown_file(const std::string& name) {
    return "\"" + name + "\" is no file of ours. Name packages as <...>.";
}

// A package's headers, and where they may be included.
struct PackageRule {
    std::string header; // how the name begins
    std::vector<std::string> places;
};

const std::vector<PackageRule> package_rules{
    {"glad/", {"common/gpu/gl.h"}},
    {"GL/", {"common/gpu/context/osmesa.cpp"}},
    {"EGL/", {"common/gpu/context/egl.cpp", "visualizer/vtk/"}},
    {"GLFW/", {"common/gpu/context/window.cpp", "common/program/window/glfw/"}},
    {"tiny_obj_loader.h", {"common/scene/obj/load_obj.cpp"}},
    {"assimp/", {"common/scene/import/importer/there/"}},
    {"toml++/", {"common/scene/toml/"}},
    {"stb_", {"common/image/"}},
    {"CLI/", {"common/program/", "visualizer/"}},
    {"nlohmann/",
     {"common/basics/numbers.cpp", "chapters/", "visualizer/", "scripts/course/answers/",
      "tests/"}},
    {"vtk", {"visualizer/vtk/", "tests/whole/drawing/"}},
    {"X11/", {"visualizer/vtk/"}},
    {"boost/", {"common/reference/", "tests/"}},
    {"embree3/", {"common/reference/embree/there/"}},
    {"embree4/", {"common/reference/embree/there/"}},
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

std::vector<std::string> find_undeclared_uses(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, {"common"}, cpp_endings)) {
        const std::string module = module_of(file);
        for (const Include& include : includes_of(root / file)) {
            const std::string used = module_of(find_included(root, file, include.name));
            if (!used.empty() && used != module && !contains(uses_of(root, module), used)) {
                faults.push_back(fault_at(file, include.line, undeclared_use(module, used)));
            }
        }
    }
    return faults;
}

std::vector<std::string> find_dead_uses(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& module : list_targets(root, "common")) {
        std::set<std::string> included;
        for (const std::string& file : list_files(root, {"common/" + module}, cpp_endings)) {
            for (const Include& include : includes_of(root / file)) {
                included.insert(module_of(find_included(root, file, include.name)));
            }
        }
        for (const std::string& used : uses_of(root, module)) {
            if (!included.contains(used)) {
                faults.push_back(dead_use(module, used));
            }
        }
    }
    return faults;
}

std::vector<std::string> find_uses_beyond_the_table(const fs::path& root) {
    std::ifstream document(root / "docs" / "architecture.md");
    const auto table = read_table(document);
    std::vector<std::string> faults;
    for (const std::string& module : list_targets(root, "common")) {
        const auto row = table.find(module);
        if (row == table.end()) {
            faults.push_back("docs/architecture.md: the table of modules has no row common/" +
                             module + ".");
            continue;
        }
        for (const std::string& used : uses_of(root, module)) {
            if (!row->second.contains(used)) {
                faults.push_back("common/" + module + "/CMakeLists.txt: USES names " + used +
                                 ", which the table of docs/architecture.md does not allow.");
            }
        }
    }
    for (const auto& [module, allowed] : table) {
        if (!fs::exists(root / "common" / module)) {
            faults.push_back("docs/architecture.md: there is no common/" + module + ".");
        }
    }
    return faults;
}

std::vector<std::string> find_includes_against_the_arrow(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, cpp_folders, cpp_endings)) {
        for (const Include& include : includes_of(root / file)) {
            if (!include.quoted) {
                continue;
            }
            const std::string included = find_included(root, file, include.name);
            if (included.empty()) {
                faults.push_back(fault_at(file, include.line, unknown_file(include.name)));
                continue;
            }
            const std::string why_not = objection(file, included);
            if (!why_not.empty()) {
                faults.push_back(fault_at(file, include.line, why_not));
            }
        }
    }
    return faults;
}

std::vector<std::string> find_scattered_packages(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, cpp_folders, cpp_endings)) {
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
