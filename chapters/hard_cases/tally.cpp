#include "tally.h"

#include <algorithm>
#include <cstring>

namespace raysteps {

namespace {

bool is_same(const Hit& a, const Hit& b) {
    if (a.triangle == no_triangle && b.triangle == no_triangle) {
        return std::memcmp(&a.t, &b.t, sizeof a.t) == 0;
    }
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

void Tallies::add(const TallyKey& key, std::size_t tried, std::size_t wrong) {
    auto tally = std::find_if(tallies_.begin(), tallies_.end(), [&](const Tally& known) {
        return known.key.method == key.method && known.key.where == key.where &&
               known.key.expected == key.expected;
    });
    if (tally == tallies_.end()) {
        tally = tallies_.insert(tally, {key});
    }
    tally->tried += tried;
    tally->wrong += wrong;
}

std::vector<TrialRow> Tallies::rows() const {
    std::vector<TrialRow> rows;
    for (const Tally& tally : tallies_) {
        const auto row = tally.key.promised ? promised_row : reported_row;
        rows.push_back(
            row(tally.key.method, tally.key.where, tally.key.expected, tally.wrong, tally.tried));
    }
    return rows;
}

std::size_t count_other_hits(std::span<const Hit> a, std::span<const Hit> b) {
    std::size_t different = a.size() == b.size() ? 0 : a.size() + b.size();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        different += is_same(a[i], b[i]) ? 0 : 1;
    }
    return different;
}

std::size_t count_unanswered(std::span<const Hit> hits, int triangles) {
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [&](const Hit& hit) {
        return hit.triangle < no_triangle || hit.triangle >= triangles;
    }));
}

} // namespace raysteps
