#include "include_rules.h"

#include "source_tree.h"

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> cpp_endings{".h", ".cpp", ".inc"};

std::string first_folder(const std::string& path) {
    return path.substr(0, path.find('/'));
}

// The file that an include names, from the root: beside the file itself, or in one of the folders
// that the compiler is told. Empty where the file is none of ours.
std::string find_included(const fs::path& root, const std::string& from, const std::string& name) {
    const std::string beside = fs::path(from).parent_path().generic_string();
    for (const std::string& folder :
         {beside, std::string("common"), std::string("shaders"), std::string("tests"),
          std::string("chapters"), std::string()}) {
        const fs::path path = (fs::path(folder) / name).lexically_normal();
        if (fs::is_regular_file(root / path)) {
            return path.generic_string();
        }
    }
    return "";
}

// common/scene/scene.h belongs to scene; empty for a file outside of common.
std::string module_of(const std::string& file) {
    const bool in_common = first_folder(file) == "common";
    return in_common ? first_folder(file.substr(std::string("common/").size())) : "";
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
        const bool other_chapter =
            origin == "chapters" && fs::path(from).parent_path() != fs::path(to).parent_path();
        return other_chapter ? fact + "a chapter includes nothing of another." : "";
    }
    if (target == "visualizer") {
        return fact + "nothing includes the visualizer but its tests.";
    }
    if (origin == "visualizer" && (module_of(to) == "gpu" || module_of(to) == "render")) {
        return fact + "VTK and the renderer's OpenGL must not meet in one process.";
    }
    if (target == "tests" || target == "chapters") {
        return fact + "nothing includes " + target + "/ but " + target + "/ itself.";
    }
    if (target == "shaders" && module_of(from) != "geometry" && module_of(from) != "mirror") {
        return fact + "shaders are C++ only in common/geometry and common/mirror.";
    }
    return "";
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

std::vector<std::string> find_includes_against_the_arrow(const fs::path& root) {
    std::vector<std::string> faults;
    for (const std::string& file :
         list_files(root, {"common", "chapters", "tests", "visualizer"}, cpp_endings)) {
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
