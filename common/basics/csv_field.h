#pragma once

#include <string>

namespace raysteps {

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
