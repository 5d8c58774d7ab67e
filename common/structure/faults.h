#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace raysteps {

// All faults of one kind: how many, and a sentence on each of the first ten.
struct FaultKind {
    std::string name;
    std::size_t count = 0;
    std::vector<std::string> first;
};

// What is wrong with a structure, kind by kind, in the order in which they were found.
struct FaultList {
    std::vector<FaultKind> kinds;

    // Counts a fault. The sentence is asked for only where it is kept: there may be millions.
    template <class Sentence>
    void add(const std::string& kind, const Sentence& sentence) {
        constexpr std::size_t most_told = 10;
        auto known = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const FaultKind& each) { return each.name == kind; });
        if (known == kinds.end()) {
            known = kinds.insert(kinds.end(), FaultKind{kind, 0, {}});
        }
        if (++known->count <= most_told) {
            known->first.push_back(sentence());
        }
    }
};

inline std::size_t count_of(const FaultList& faults, const std::string& kind) {
    const auto known = std::find_if(faults.kinds.begin(), faults.kinds.end(),
                                    [&](const FaultKind& each) { return each.name == kind; });
    return known == faults.kinds.end() ? 0 : known->count;
}

// The sentences of all kinds.
inline std::vector<std::string> sentences_of(const FaultList& faults) {
    std::vector<std::string> sentences;
    for (const FaultKind& kind : faults.kinds) {
        sentences.insert(sentences.end(), kind.first.begin(), kind.first.end());
    }
    return sentences;
}

} // namespace raysteps
