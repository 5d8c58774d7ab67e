#pragma once

#include "trial.h"

#include <span>

namespace raysteps {

// Whether a promise is made of the method, and which.
struct TallyKey {
    std::string method;
    std::string where;
    std::string expected;
    bool promised = true;
};

// Counts of the batches of a case, added up for each method; rows in the order of the first batch.
class Tallies {
public:
    void add(const TallyKey& key, std::size_t tried, std::size_t wrong);
    std::vector<TrialRow> rows() const;

private:
    struct Tally {
        TallyKey key;
        std::size_t tried = 0;
        std::size_t wrong = 0;
    };
    std::vector<Tally> tallies_;
};

// How many hits differ in a bit of t, u, v or the triangle. Of misses, u and v mean nothing.
std::size_t count_other_hits(std::span<const Hit> a, std::span<const Hit> b);

// How many hits are neither a miss nor one of that many triangles.
std::size_t count_unanswered(std::span<const Hit> hits, int triangles);

} // namespace raysteps
