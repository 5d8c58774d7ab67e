#include "scene/toml/toml_values.h"

#include "basics/text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace raysteps {

namespace {

bool comes_back(std::string_view text, float number) {
    double value = 0.0; // as toml++ reads it
    std::from_chars(text.data(), text.data() + text.size(), value);
    return static_cast<float>(value) == number;
}

std::string short_text(double value) {
    char text[32];
    const std::to_chars_result result = std::to_chars(text, text + sizeof text, value);
    return {text, result.ptr};
}

std::string range_text(TomlRange range) {
    return "between " + short_text(range.lowest) + " and " + short_text(range.highest);
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

std::string toml_number_text(double number) {
    char buffer[40];
    const std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
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

InputError toml_error(const toml::source_region& source, const std::string& sentence) {
    std::string place = source.path ? *source.path : "TOML";
    if (source.begin.line > 0) {
        place +=
            ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
    }
    return InputError(place + ": " + sentence);
}

void check_toml_keys(const toml::table& table, std::string_view table_name,
                     const std::vector<std::string_view>& known) {
    for (const auto& [key, value] : table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) {
            continue;
        }
        throw toml_error(key.source(),
                         std::string(table_name) + " has no key " + in_quotes(key.str()) + "." +
                             did_you_mean(key.str(), known) + " It takes " + listed(known) + ".");
    }
}

const toml::table& toml_table(const toml::node& node, std::string_view key) {
    if (const toml::table* table = node.as_table()) {
        return *table;
    }
    throw toml_error(node.source(), std::string(key) + " must be a table.");
}

const toml::array& toml_array(const toml::node& node, std::string_view key) {
    if (const toml::array* array = node.as_array()) {
        return *array;
    }
    throw toml_error(node.source(), std::string(key) + " must be an array.");
}

std::string toml_string(const toml::node& node, std::string_view key) {
    if (const toml::value<std::string>* text = node.as_string()) {
        return text->get();
    }
    throw toml_error(node.source(), std::string(key) + " must be a text in quotation marks.");
}

double toml_number(const toml::node& node, std::string_view key, TomlRange range) {
    if (!node.is_number()) {
        throw toml_error(node.source(),
                         std::string(key) + " must be a number " + range_text(range) + ".");
    }
    const toml::value<std::int64_t>* whole = node.as_integer();
    const double value =
        whole != nullptr ? static_cast<double>(whole->get()) : node.as_floating_point()->get();
    const bool is_in_range = value >= range.lowest && value <= range.highest; // so NaN is not
    if (!is_in_range) {
        throw toml_error(node.source(), std::string(key) + " is " + short_text(value) +
                                            ", but must be " + range_text(range) + ".");
    }
    return value;
}

std::vector<double> toml_numbers(const toml::node& node, std::string_view key, std::size_t count,
                                 TomlRange range) {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != count) {
        throw toml_error(node.source(), std::string(key) + " must be an array of " +
                                            std::to_string(count) + " numbers.");
    }
    std::vector<double> numbers;
    for (const toml::node& element : *array) {
        numbers.push_back(toml_number(element, key, range));
    }
    return numbers;
}

glm::vec3 toml_vec3(const toml::node& node, std::string_view key, TomlRange range) {
    const std::vector<double> numbers = toml_numbers(node, key, 3, range);
    return glm::vec3(glm::dvec3(numbers[0], numbers[1], numbers[2]));
}

} // namespace raysteps
