#pragma once

#include "state.h"

#include <string>
#include <utility>
#include <vector>

namespace raysteps::view {

// The choices of a state as words: in options, files and on the screen.
template <class Choice>
using Words = std::vector<std::pair<std::string, Choice>>;

const Words<ModelStyle>& model_words();
const Words<CellFilter>& filter_words();
const Words<CellColor>& color_words();
const Words<HeatMap>& heat_map_words();
const Words<SortBy>& sort_words();

// The word of a choice.
template <class Choice>
std::string word_of(const Words<Choice>& words, Choice choice) {
    for (const auto& [word, meant] : words) {
        if (meant == choice) {
            return word;
        }
    }
    return "";
}

// The choice after this one; after the last one, the first.
template <class Choice>
Choice next_of(const Words<Choice>& words, Choice choice) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].second == choice) {
            return words[(i + 1) % words.size()].second;
        }
    }
    return words.front().second;
}

} // namespace raysteps::view
