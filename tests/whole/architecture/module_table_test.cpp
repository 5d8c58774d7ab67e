#include "catch.h"
#include "source_tree.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace {

// The words of a row's last cell, up to what the module never includes.
std::set<std::string> words_of(const std::string& cell) {
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
            table[match[1]] = words_of(match[2]);
        }
    }
    return table;
}

} // namespace

TEST_CASE("a row of the table of modules names what the module may include", "[architecture]") {
    std::istringstream document("| module | what it is | may include |\n"
                                "| common/scene | scenes | error, geometry; never gpu |\n"
                                "| chapters | compose | common |\n");
    const auto table = read_table(document);
    REQUIRE(table.size() == 1);
    CHECK(table.at("scene") == std::set<std::string>{"error", "geometry"});
}

TEST_CASE("every module links only what the table of modules allows", "[architecture]") {
    const std::filesystem::path root = RAYSTEPS_SOURCE_DIR;
    std::ifstream document(root / "docs" / "architecture.md");
    const auto table = read_table(document);
    const std::vector<std::string> modules = list_targets(root, "common");
    REQUIRE(modules.size() >= 10);
    for (const std::string& module : modules) {
        CAPTURE(module);
        REQUIRE(table.count(module) == 1);
        const std::set<std::string>& allowed = table.at(module);
        for (const std::string& used :
             words_of_call(root / "common" / module / "CMakeLists.txt", "add_module", "USES")) {
            CAPTURE(used);
            CHECK(allowed.count(used) == 1);
        }
    }
}
