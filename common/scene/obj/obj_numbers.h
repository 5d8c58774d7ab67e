#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace raysteps {

// Coordinates above this are refused: the square of a distance between two such points,
// 3 * (2 * 1.8e18)^2 = 3.9e37, is still a float (at most 3.4e38).
inline constexpr double greatest_coordinate = 1.8e18;

// The number that the whole word spells, which may be infinite or no number (`inf`, `nan`);
// nothing where the word spells no number. What a double cannot hold counts as infinite.
std::optional<double> to_number(std::string_view word);

// The whole number that the word spells; nothing where it spells none or one beyond 64 bits.
std::optional<std::int64_t> to_whole_number(std::string_view word);

// The shortest text that reads back to the same float.
std::string to_text(float number);

} // namespace raysteps
