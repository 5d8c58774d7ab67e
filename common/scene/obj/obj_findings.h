#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace raysteps {

// "bunny.obj:1204: ", the place that a sentence is about.
std::string place(const std::filesystem::path& path, std::int64_t line);

// A word from a file as it may stand in a sentence: in quotes, at most 40 characters, all
// printable.
std::string in_quotes(std::string_view word);

// Collects what was corrected or dropped in a file: one sentence for each kind of finding with its
// count and first lines, however often it was found.
class Findings {
public:
    // The sentence comes without its full stop.
    void note(const std::string& sentence, std::int64_t line);

    // The sentences about the file, in the order in which their kinds were first found.
    std::vector<std::string> sentences(const std::filesystem::path& path) const;

private:
    struct Finding {
        std::string sentence;
        std::int64_t count = 0;
        std::vector<std::int64_t> first_lines;
    };

    std::vector<Finding> findings_;
    std::unordered_map<std::string, std::size_t> index_of_sentence_;
};

} // namespace raysteps
