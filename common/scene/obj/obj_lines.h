#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

struct TextLine {
    std::int64_t number = 0; // counted from 1; of joined lines, the first
    std::string_view text;   // valid until the next line is read
};

// Reads the lines of an OBJ or MTL text: LF, CRLF or CR end a line, a backslash before the end
// joins the next one, and a UTF-8 byte order mark at the start is left out. A comment joins
// nothing, because comments end in paths such as C:\models\.
class LineReader {
public:
    explicit LineReader(std::string_view text);
    std::optional<TextLine> next();

private:
    std::string_view take_line();

    std::string_view rest_;
    std::string joined_;
    std::int64_t lines_taken_ = 0;
};

// The words of a line, which are set apart by spaces and tabs.
std::vector<std::string_view> split_words(std::string_view text);

// The words without a comment: those before the first that begins with '#'.
std::vector<std::string_view> split_values(std::string_view text);

// What follows the first word, without the space around it: a name, which may hold spaces.
std::string_view after_first_word(std::string_view text);

} // namespace raysteps
