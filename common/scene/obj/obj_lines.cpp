#include "scene/obj_lines.h"

#include <algorithm>

namespace raysteps {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view spaces = " \t\v\f";

bool ends_line(char character) {
    return character == '\n' || character == '\r';
}

bool joins_next(std::string_view line) {
    return !line.empty() && line.back() == '\\';
}

bool is_comment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(spaces);
    return first != std::string_view::npos && line[first] == '#';
}

} // namespace

LineReader::LineReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with(byte_order_mark))
        rest_.remove_prefix(byte_order_mark.size());
}

std::optional<TextLine> LineReader::next() {
    if (rest_.empty())
        return std::nullopt;
    const std::string_view first = take_line();
    const std::int64_t number = lines_taken_;
    if (is_comment(first) || !joins_next(first))
        return TextLine{number, first};
    joined_ = first;
    while (joins_next(joined_)) {
        joined_.back() = ' ';
        if (rest_.empty())
            break;
        joined_ += take_line();
    }
    return TextLine{number, joined_};
}

std::string_view LineReader::take_line() {
    const auto end = std::find_if(rest_.begin(), rest_.end(), ends_line);
    const std::string_view line = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(line.size());
    if (rest_.starts_with("\r\n"))
        rest_.remove_prefix(2);
    else if (!rest_.empty())
        rest_.remove_prefix(1);
    ++lines_taken_;
    return line;
}

std::vector<std::string_view> split_words(std::string_view text) {
    std::vector<std::string_view> words;
    std::size_t start = text.find_first_not_of(spaces);
    while (start != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(spaces, start), text.size());
        words.push_back(text.substr(start, end - start));
        start = text.find_first_not_of(spaces, end);
    }
    return words;
}

std::vector<std::string_view> split_values(std::string_view text) {
    std::vector<std::string_view> words = split_words(text);
    const auto starts_comment = [](std::string_view word) { return word.starts_with('#'); };
    words.erase(std::find_if(words.begin(), words.end(), starts_comment), words.end());
    return words;
}

std::string_view after_first_word(std::string_view text) {
    const std::size_t word = std::min(text.find_first_not_of(spaces), text.size());
    const std::size_t word_end = std::min(text.find_first_of(spaces, word), text.size());
    const std::size_t start = std::min(text.find_first_not_of(spaces, word_end), text.size());
    const std::size_t last = text.find_last_not_of(spaces);
    return start == text.size() ? std::string_view{} : text.substr(start, last + 1 - start);
}

} // namespace raysteps
