#pragma once

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// The whole text as a number; nothing where it is none.
template <class Number>
std::optional<Number> parse_number(const std::string& text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return number;
}

// The words between the separators: of `a,,b` three, of nothing one.
std::vector<std::string> split_words(const std::string& text, char separator);

// Finite numbers between commas, as many as there are words; nothing where one is none.
std::optional<std::vector<float>> parse_numbers(const std::string& text);

struct PictureSize {
    int width;
    int height;
};

// `640x480`, or `512` for a square; each side from 1 to 16384. Throws InputError.
PictureSize parse_size(const std::string& text);

// The word that becomes `text` with the fewest letters added, removed or changed (Levenshtein,
// "Binary codes capable of correcting deletions, insertions and reversals", 1966), for "did you
// mean ...?". Nothing where a third of the letters or more would have to differ.
std::string_view nearest_word(std::string_view text, const std::vector<std::string_view>& words);

// Throws InputError that names the file and the line where a zero byte shows that this is no text.
void check_is_text(std::string_view text, const std::filesystem::path& path);

// What printf would print, however long it is.
template <class... Values>
std::string formatted(const char* pattern, Values... values) {
    const int length = std::snprintf(nullptr, 0, pattern, values...);
    std::string text(static_cast<std::size_t>(length), '\0');
    std::snprintf(text.data(), text.size() + 1, pattern, values...);
    return text;
}

// A text as a field of a CSV file: in quotes where it holds commas, quotes or ends of lines
// (RFC 4180).
inline std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string field = "\"";
    for (const char letter : text) {
        field += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return field + "\"";
}

} // namespace raysteps
