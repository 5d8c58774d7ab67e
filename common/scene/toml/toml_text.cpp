#include "scene/toml_text.h"

#include <charconv>

namespace raysteps {

namespace {

bool comes_back(std::string_view text, float number) {
    double value = 0.0; // as toml++ reads it
    std::from_chars(text.data(), text.data() + text.size(), value);
    return static_cast<float>(value) == number;
}

} // namespace

// The shortest digits that mean this float. Read as a double and rounded again they are the same
// float for all but one of them, 7.038531e-26, as a trial of all showed; nine digits are the same
// float for every one, since they are off by less than half of what separates two floats.
std::string toml_number_text(float number) {
    char buffer[32];
    char* const end = buffer + sizeof buffer;
    std::string text(buffer, std::to_chars(buffer, end, number).ptr);
    if (!comes_back(text, number)) {
        text.assign(buffer, std::to_chars(buffer, end, number, std::chars_format::general, 9).ptr);
    }
    // A whole number would lose the sign of -0.
    const bool is_whole = text.find_first_of(".e") == std::string::npos;
    return is_whole ? text + ".0" : text;
}

std::string toml_string_text(std::string_view text) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string quoted = "\"";
    for (const char character : text) {
        const auto code = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            quoted += '\\';
            quoted += character;
        } else if (code < 0x20 || code == 0x7f) {
            quoted += "\\u00";
            quoted += digits[code / 16];
            quoted += digits[code % 16];
        } else {
            quoted += character;
        }
    }
    return quoted + "\"";
}

} // namespace raysteps
