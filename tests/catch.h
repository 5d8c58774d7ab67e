#pragma once

// Catch2 version 3 has many headers, version 2 has one.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
inline auto contains_text(const std::string& text) {
    return Catch::Matchers::ContainsSubstring(text);
}
#else
#include <catch2/catch.hpp>
inline auto contains_text(const std::string& text) {
    return Catch::Matchers::Contains(text);
}
#endif

inline auto starts_with_text(const std::string& text) {
    return Catch::Matchers::StartsWith(text);
}
