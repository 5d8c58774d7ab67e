#pragma once

#include <cstdio>
#include <string>

namespace raysteps {

// What printf would print, however long it is.
template <class... Values>
std::string formatted(const char* pattern, Values... values) {
    const int length = std::snprintf(nullptr, 0, pattern, values...);
    std::string text(static_cast<std::size_t>(length), '\0');
    std::snprintf(text.data(), text.size() + 1, pattern, values...);
    return text;
}

} // namespace raysteps
