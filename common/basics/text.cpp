#include "basics/text.h"

#include "basics/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <string>

namespace raysteps {

namespace {

constexpr int largest_side = 16384;
constexpr std::size_t most_quoted = 40; // characters of a word in a sentence

bool is_printable(char character) {
    return character >= ' ' && character <= '~';
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1); // distances of a's beginning to b's beginnings
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

} // namespace

std::vector<std::string> split_words(const std::string& text, char separator) {
    std::vector<std::string> words(1);
    for (const char letter : text) {
        if (letter == separator) {
            words.emplace_back();
        } else {
            words.back() += letter;
        }
    }
    return words;
}

std::optional<std::vector<float>> parse_numbers(const std::string& text) {
    std::vector<float> numbers;
    for (const std::string& word : split_words(text, ',')) {
        const auto number = parse_number<float>(word);
        if (!number || !std::isfinite(*number)) {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

PictureSize parse_size(const std::string& text) {
    const std::vector<std::string> words = split_words(text, 'x');
    const auto width = parse_number<int>(words.front());
    const auto height = parse_number<int>(words.back());
    const auto fits = [](int side) { return side >= 1 && side <= largest_side; };
    if (words.size() > 2 || !width || !height || !fits(*width) || !fits(*height)) {
        throw InputError("--size " + text +
                         ": a size is WIDTHxHEIGHT, as in 640x480, each from 1 to " +
                         std::to_string(largest_side) + ".");
    }
    return {*width, *height};
}

std::string_view nearest_word(std::string_view text, const std::vector<std::string_view>& words) {
    std::string_view nearest;
    std::size_t smallest = text.size() + 1;
    for (const std::string_view word : words) {
        const std::size_t distance = edit_distance(text, word);
        if (distance < smallest && 3 * distance < word.size() + 2) {
            smallest = distance;
            nearest = word;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view given, const std::vector<std::string_view>& words) {
    const std::string_view nearest = nearest_word(given, words);
    return nearest.empty() ? "" : " Did you mean " + std::string(nearest) + "?";
}

std::string listed(const std::vector<std::string_view>& words) {
    std::string text;
    for (const std::string_view word : words) {
        text += text.empty() ? "" : ", ";
        text += word;
    }
    return text;
}

std::string no_such_choice(std::string_view option, std::string_view given, std::string_view kind,
                           const std::vector<std::string_view>& choices) {
    std::string sentence(option);
    sentence += sentence.empty() ? "" : " ";
    sentence += given;
    sentence += ": there is no such ";
    sentence += kind;
    return sentence + "." + did_you_mean(given, choices) + " Take one of " + listed(choices) + ".";
}

std::string spoken(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string in_quotes(std::string_view word) {
    std::string text = "\"";
    for (const char character : word.substr(0, most_quoted)) {
        text += is_printable(character) ? character : '?';
    }
    return text + (word.size() > most_quoted ? "...\"" : "\"");
}

std::string readable(double number) {
    const double size = std::abs(number);
    if (!(size < 1e15)) { // it has no longer all its digits, or is no number
        return std::to_string(number);
    }
    std::array<char, 32> letters{};
    if (number != std::floor(number) && size < 999.5) {
        std::snprintf(letters.data(), letters.size(), "%.2e", number);
        const int power_of_ten = std::stoi(std::string(letters.data()).substr(number < 0 ? 6 : 5));
        std::snprintf(letters.data(), letters.size(), "%.*f", std::max(0, 2 - power_of_ten),
                      number);
        return letters.data();
    }
    std::snprintf(letters.data(), letters.size(), "%.0f", number);
    std::string text = letters.data();
    const std::size_t sign = number < 0.0 ? 1 : 0;
    for (std::size_t end = text.size(); end > sign + 3; end -= 3) {
        text.insert(end - 3, ",");
    }
    return text;
}

std::string shortest_text(float number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

void check_is_text(std::string_view text, const std::filesystem::path& path) {
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) {
        return;
    }
    const auto lines_before = std::count(text.begin(), text.begin() + zero, '\n');
    throw InputError(path.string() + ":" + std::to_string(lines_before + 1) +
                     ": holds a zero byte, so it is not plain text. Save it as UTF-8 text.");
}

} // namespace raysteps
