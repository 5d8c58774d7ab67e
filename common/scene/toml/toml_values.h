#pragma once

#include "basics/error.h"

#include <glm/vec3.hpp>
#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// The number as TOML, which reads back to the same bits; it is finite.
std::string toml_number_text(float number);
std::string toml_number_text(double number);

// The text in quotation marks, as TOML.
std::string toml_string_text(std::string_view text);

// The values of a TOML file, checked. All of these throw InputError with file, line and column.

// An error about the text at this place.
InputError toml_error(const toml::source_region& source, const std::string& sentence);

// The numbers that a key takes, both ends included.
struct TomlRange {
    double lowest = 0.0;
    double highest = 0.0;
};

// Refuses a key that is not among the known ones.
void check_toml_keys(const toml::table& table, std::string_view table_name,
                     const std::vector<std::string_view>& known);

const toml::table& toml_table(const toml::node& node, std::string_view key);
const toml::array& toml_array(const toml::node& node, std::string_view key);
std::string toml_string(const toml::node& node, std::string_view key);
double toml_number(const toml::node& node, std::string_view key, TomlRange range);
std::vector<double> toml_numbers(const toml::node& node, std::string_view key, std::size_t count,
                                 TomlRange range);
glm::vec3 toml_vec3(const toml::node& node, std::string_view key, TomlRange range);

} // namespace raysteps
