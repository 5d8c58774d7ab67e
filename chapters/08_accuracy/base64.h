#pragma once

#include <string>
#include <string_view>

namespace raysteps {

// Bytes as text, for pictures within a page (Josefsson, "The Base16, Base32, and Base64 Data
// Encodings", RFC 4648, 2006).
std::string to_base64(std::string_view bytes);

} // namespace raysteps
