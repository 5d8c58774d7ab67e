#pragma once

#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// The number that the whole text spells; nothing where it spells none.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return number;
}

// The words between the separators: of `a,,b` three, of nothing one.
std::vector<std::string> split_words(const std::string& text, char separator);

// Finite numbers between commas; nothing where one of the words is not a finite number.
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

// " Did you mean sphereflake?" where a word is near enough, else nothing.
std::string did_you_mean(std::string_view given, const std::vector<std::string_view>& words);

// `--slab kay: there is no such part. Did you mean kay_kajiya? Take one of kay_kajiya, williams.`
// The option, which may be empty, is what the choice was given for.
std::string no_such_choice(std::string_view option, std::string_view given, std::string_view kind,
                           const std::vector<std::string_view>& choices);

// "one, two, three".
std::string listed(const std::vector<std::string_view>& words);

// `kay_kajiya` as people read it: kay kajiya.
std::string spoken(std::string name);

// A word from a file as it may stand in a sentence: in quotes, at most 40 characters, all
// printable.
std::string in_quotes(std::string_view word);

// A number as people read it: whole, and from a thousand on, with commas, 277,255; else with three
// digits, 2.70 or 0.0398.
std::string readable(double number);

// The shortest text that reads back to the same float.
std::string shortest_text(float number);

// Throws InputError that names the file and the line where a zero byte shows that this is no text.
void check_is_text(std::string_view text, const std::filesystem::path& path);

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
