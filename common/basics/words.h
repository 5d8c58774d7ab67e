#pragma once

#include <charconv>
#include <optional>
#include <string>
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

} // namespace raysteps
