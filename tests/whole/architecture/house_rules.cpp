#include "rules.h"
#include "source_tree.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> folders_without_tests{"common", "chapters", "visualizer", "scripts"};

// Each file with the files of ours that it includes.
std::map<std::string, std::set<std::string>> read_includes(const fs::path& root) {
    std::map<std::string, std::set<std::string>> included;
    for (const std::string& file : list_files(root, folders_without_tests, cpp_endings)) {
        for (const Include& include : includes_of(root / file)) {
            const std::string name = find_included(root, file, include.name);
            if (include.quoted && !name.empty()) {
                included[file].insert(name);
            }
        }
    }
    return included;
}

// What stands before a brace or semicolon at the left margin, and the namespaces around it. What is
// in a namespace without a name is left out: it has no other to meet.
struct Statement {
    std::string text;
    std::string space;
    int line = 0;
};

std::vector<Statement> statements_of(const fs::path& file) {
    static const std::regex opens(R"(^(?:inline )?namespace (?:(\w+(?:::\w+)*) )?\{$)");
    std::vector<Statement> statements;
    std::vector<std::string> spaces;
    Statement statement;
    bool in_body = false;
    int number = 0;
    for (std::string line : code_lines(file)) {
        ++number;
        line.erase(line.find_last_not_of(" \r") + 1);
        const bool at_margin = !line.empty() && line[0] != ' ' && line[0] != '#';
        std::smatch match;
        if (in_body) {
            in_body = !(at_margin && line[0] == '}');
            continue;
        }
        if (std::regex_match(line, match, opens)) {
            spaces.push_back(match[1]);
            continue;
        }
        if (line == "}" && !spaces.empty()) {
            spaces.pop_back();
            continue;
        }
        if (statement.text.empty() && !at_margin) {
            continue;
        }
        statement.line = statement.text.empty() ? number : statement.line;
        statement.text += line + " ";
        if (line.find_first_of("{};") == std::string::npos) {
            continue;
        }
        in_body =
            std::count(line.begin(), line.end(), '{') > std::count(line.begin(), line.end(), '}');
        if (std::find(spaces.begin(), spaces.end(), "") == spaces.end()) {
            for (const std::string& space : spaces) {
                statement.space += space + "::";
            }
            statements.push_back(statement);
        }
        statement = {};
    }
    return statements;
}

// The type or the inline function that a statement defines; empty where it defines none.
std::string defined_name(const Statement& statement) {
    static const std::regex type(
        R"(^(?:struct|class|enum class|enum|union) (\w+)(?: final)?(?: ?:[^:][^;()]*)? ?\{.*)");
    static const std::regex function(
        R"(^(?:template <[^>]*> )?(?:constexpr )?inline [^=;(]*?(\w+\([^{]*\))[^{)]*\{.*)");
    std::smatch match;
    if (std::regex_match(statement.text, match, type) ||
        std::regex_match(statement.text, match, function)) {
        return statement.space + std::regex_replace(match[1].str(), std::regex(" +"), " ");
    }
    return "";
}

// In such a folder stand the same names for where a package is missing.
bool stands_in_for_another(const std::string& file) {
    return file.find("/absent/") != std::string::npos;
}

} // namespace

std::vector<std::string> list_sources_that_see(const fs::path& root, const std::string& header) {
    const auto included = read_includes(root);
    std::set<std::string> seeing;
    for (const std::string& file : list_files(root, folders_without_tests, cpp_endings)) {
        for (const Include& include : includes_of(root / file)) {
            if (include.name == header) {
                seeing.insert(file);
            }
        }
    }
    for (std::size_t before = 0; before != seeing.size();) {
        before = seeing.size();
        for (const auto& [file, names] : included) {
            if (std::any_of(names.begin(), names.end(),
                            [&](const std::string& name) { return seeing.contains(name); })) {
                seeing.insert(file);
            }
        }
    }
    std::vector<std::string> sources;
    std::copy_if(seeing.begin(), seeing.end(), std::back_inserter(sources),
                 [](const std::string& file) { return file.ends_with(".cpp"); });
    return sources;
}

std::vector<std::string> list_headers_of_one_file(const fs::path& root) {
    std::map<std::string, std::set<std::string>> includers;
    for (const auto& [file, names] : read_includes(root)) {
        for (const std::string& name : names) {
            const bool own =
                fs::path(file).replace_extension() == fs::path(name).replace_extension();
            if (name.starts_with("common/") && name.ends_with(".h") && !own) {
                includers[name].insert(file);
            }
        }
    }
    std::vector<std::string> headers;
    for (const auto& [header, files] : includers) {
        if (files.size() == 1) {
            headers.push_back(header + " is for " + *files.begin() + " alone.");
        }
    }
    return headers;
}

std::vector<std::string> find_double_names(const fs::path& root) {
    struct Place {
        std::string file;
        int line;
    };
    std::map<std::string, Place> places;
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, cpp_folders, {".h", ".cpp"})) {
        if (stands_in_for_another(file)) {
            continue;
        }
        for (const Statement& statement : statements_of(root / file)) {
            const std::string name = defined_name(statement);
            const Place& first =
                places.try_emplace(name, Place{file, statement.line}).first->second;
            // Twice in one file are two sides of an #if, or the compiler objects.
            if (!name.empty() && first.file != file) {
                faults.push_back(fault_at(file, statement.line,
                                          name + " is defined in " + first.file + ":" +
                                              std::to_string(first.line) + " too."));
            }
        }
    }
    return faults;
}

std::vector<std::string> find_misnamed_tests(const fs::path& root) {
    static const std::regex test(R"(^(?:TEMPLATE_)?TEST_CASE\b.*)");
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, {"tests"}, cpp_endings)) {
        const std::vector<std::string> lines = code_lines(root / file);
        const bool has_tests = std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
            return std::regex_match(line, test);
        });
        if (has_tests != file.ends_with("_test.cpp")) {
            faults.push_back(file + (has_tests ? ": has tests, so its name ends in _test.cpp."
                                               : ": has no test, so its name does not say so."));
        }
    }
    return faults;
}
