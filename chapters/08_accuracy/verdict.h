#pragma once

#include "trade_off.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// One method over all families: faults and errors of the family where it did worst, and the mean of
// its costs.
struct MethodSummary {
    std::string method;
    std::optional<FaultRate> faults{}; // nothing where the trade-off counts none
    std::string worst_family{};        // by faults
    std::size_t missed = 0;            // hits, in all families together
    std::optional<double> error{};     // the greatest of 99 % of each family
    double similarity = 1.0;           // of pictures, the least
    Cost cost{};
};

// In the order of the trade-off.
std::vector<MethodSummary> summarize_methods(const TradeOffResult& result);

// Whether a is surely better than b in one respect, and not surely worse in any other. Of costs and
// faults, ranges that overlap decide nothing; errors are compared as they are.
bool dominates(const MethodSummary& a, const MethodSummary& b);

bool is_dominated(const MethodSummary& method, std::span<const MethodSummary> all);

// What to take for a need, as far as the measurement tells: the cheapest method that will do, and
// those whose ranges overlap with its range, so that no rank is given among them.
struct Advice {
    std::string need;
    std::string trade_off;
    std::vector<std::string> methods; // the cheapest median first; empty where none will do
    std::string condition;            // that they had to meet
};

// For preview, default, and reference; where rays were traced at a closed mesh also for that:
// methods by which none of them was lost. Nothing for trade-offs that change only the speed.
std::vector<Advice> advise(const TradeOffResult& result);

} // namespace raysteps
