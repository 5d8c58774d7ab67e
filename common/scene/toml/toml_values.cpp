#include "scene/toml_values.h"

#include "scene/nearest_word.h"
#include "scene/obj_findings.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace raysteps {

namespace {

std::string short_text(double value) {
    char text[32];
    const std::to_chars_result result = std::to_chars(text, text + sizeof text, value);
    return {text, result.ptr};
}

std::string range_text(TomlRange range) {
    return "between " + short_text(range.lowest) + " and " + short_text(range.highest);
}

} // namespace

InputError toml_error(const toml::source_region& source, const std::string& sentence) {
    std::string place = source.path ? *source.path : "TOML";
    if (source.begin.line > 0) {
        place +=
            ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
    }
    return InputError(place + ": " + sentence);
}

void check_toml_keys(const toml::table& table, std::string_view place,
                     const std::vector<std::string_view>& known) {
    for (const auto& [key, value] : table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) {
            continue;
        }
        std::string names;
        for (const std::string_view name : known) {
            names += names.empty() ? "" : ", ";
            names += name;
        }
        const std::string nearest(nearest_word(key.str(), known));
        std::string sentence = std::string(place) + " has no key " + in_quotes(key.str()) + ".";
        sentence += nearest.empty() ? "" : " Did you mean " + nearest + "?";
        sentence += " It takes " + names + ".";
        throw toml_error(key.source(), sentence);
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
