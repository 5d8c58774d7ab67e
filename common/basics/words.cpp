#include "parse/words.h"

#include <cmath>

namespace raysteps {

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

} // namespace raysteps
