#pragma once

#include <string_view>
#include <vector>

namespace raysteps {

// The word that becomes `text` with the fewest letters added, removed or changed (Levenshtein,
// "Binary codes capable of correcting deletions, insertions and reversals", 1966), for "did you
// mean ...?". Nothing where a third of the letters or more would have to differ.
std::string_view nearest_word(std::string_view text, const std::vector<std::string_view>& words);

} // namespace raysteps
