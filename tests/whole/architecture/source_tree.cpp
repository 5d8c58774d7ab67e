#include "source_tree.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace fs = std::filesystem;

namespace {

bool is_keyword(const std::string& word) {
    return std::all_of(word.begin(), word.end(), [](unsigned char letter) {
        return std::isupper(letter) != 0 || letter == '_';
    });
}

std::string text_without_cmake_comments(const fs::path& file) {
    std::ifstream stream(file);
    std::string text;
    for (std::string line; std::getline(stream, line);) {
        text += line.substr(0, line.find('#')) + "\n";
    }
    return text;
}

} // namespace

std::vector<std::string> list_files(const fs::path& root, const std::vector<std::string>& folders,
                                    const std::vector<std::string>& endings) {
    const auto is_wanted = [&](const std::string& name) {
        return endings.empty() ||
               std::any_of(endings.begin(), endings.end(),
                           [&](const std::string& ending) { return name.ends_with(ending); });
    };
    std::vector<std::string> files;
    for (const std::string& folder : folders) {
        if (!fs::exists(root / folder)) {
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string name = fs::relative(entry.path(), root).generic_string();
            if (entry.is_regular_file() && is_wanted(name)) {
                files.push_back(name);
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> list_targets(const fs::path& root, const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(root / folder)) {
        if (fs::exists(entry.path() / "CMakeLists.txt")) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> code_lines(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line.substr(0, line.find("//")));
    }
    return lines;
}

std::vector<Include> includes_of(const fs::path& file) {
    static const std::regex form(R"(^\s*#\s*include\s*(?:"([^"]+)\"|<([^>]+)>).*$)");
    std::vector<Include> includes;
    int number = 0;
    for (const std::string& line : code_lines(file)) {
        ++number;
        std::smatch match;
        if (std::regex_match(line, match, form)) {
            const bool quoted = match[1].matched;
            includes.push_back({quoted ? match[1].str() : match[2].str(), quoted, number});
        }
    }
    return includes;
}

std::string find_included(const fs::path& root, const std::string& from, const std::string& name) {
    const std::string beside = fs::path(from).parent_path().generic_string();
    for (const std::string& folder :
         {beside, std::string("common"), std::string("shaders"), std::string("tests"),
          std::string("chapters"), std::string("scripts/course/answers"),
          std::string("scripts/playground"), std::string()}) {
        const fs::path path = (fs::path(folder) / name).lexically_normal();
        if (fs::is_regular_file(root / path)) {
            return path.generic_string();
        }
    }
    return "";
}

std::vector<std::string> words_of_call(const fs::path& file, const std::string& command,
                                       const std::string& keyword) {
    const std::string text = text_without_cmake_comments(file);
    std::smatch call;
    if (!std::regex_search(text, call, std::regex("(?:^|\\n)\\s*" + command + R"(\(([^)]*)\))"))) {
        return {};
    }
    std::istringstream stream(call[1].str());
    std::vector<std::string> words;
    bool wanted = false;
    for (std::string word; stream >> word;) {
        if (is_keyword(word)) {
            wanted = word == keyword;
        } else if (wanted) {
            words.push_back(word);
        }
    }
    return words;
}

std::string fault_at(const std::string& file, int line, const std::string& what) {
    return file + ":" + std::to_string(line) + ": " + what;
}

std::string join_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}
