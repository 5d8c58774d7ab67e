#pragma once

#include <string>
#include <string_view>

namespace raysteps {

// The number as TOML, which reads back to the same bits; it is finite.
std::string toml_number_text(float number);

// The text in quotation marks, as TOML.
std::string toml_string_text(std::string_view text);

} // namespace raysteps
