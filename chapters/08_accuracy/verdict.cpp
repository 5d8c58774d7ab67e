#include "verdict.h"

#include "judges.h"

#include <algorithm>
#include <functional>

namespace raysteps {

namespace {

// What a preview may get wrong, per million, in the first family, that of ordinary
// cases.
constexpr double faults_of_preview = 1000.0;
constexpr double similarity_of_preview = 0.9;
constexpr double similarity_of_default = 0.99;

void add(MethodSummary& summary, const Measurement& one) {
    const Fault total = total_fault(one.findings);
    if (total.of > 0) {
        const FaultRate rate = fault_rate(total.count, total.of);
        if (!summary.faults || rate.counted > summary.faults->counted) {
            summary.faults = rate;
            summary.worst_family = one.family;
        }
    }
    for (const Fault& fault : one.findings.faults) {
        summary.missed += fault.name == missed_hit ? fault.count : 0;
    }
    if (one.findings.error) {
        summary.error = std::max(summary.error.value_or(0.0), one.findings.error->percentile_99);
    }
    for (const Measure& measure : one.findings.measures) {
        if (measure.name == "similarity") {
            summary.similarity = std::min(summary.similarity, measure.value);
        }
    }
    summary.cost.median += one.cost.median;
    summary.cost.lowest += one.cost.lowest;
    summary.cost.highest += one.cost.highest;
}

// -1 where a is surely less, 1 where it is surely more, 0 where nobody can tell.
int order_of(double a_lowest, double a_highest, double b_lowest, double b_highest) {
    if (a_highest < b_lowest) {
        return -1;
    }
    return a_lowest > b_highest ? 1 : 0;
}

struct Need {
    std::string name;
    std::string condition;
    std::function<bool(const MethodSummary&)> is_met;
};

// Of the first family, that of ordinary cases.
double usual_faults(const TradeOffResult& result, const std::string& method) {
    const Measurement* const one =
        measurement_of(result, method, result.measurements.front().family);
    const Fault total = one == nullptr ? Fault{} : total_fault(one->findings);
    return fault_rate(total.count, total.of).counted;
}

bool is_faultless(const MethodSummary& method) {
    return !method.faults || method.faults->counted == 0.0;
}

// Of methods that compute a picture, no pixel is ever the same: how alike it looks decides.
std::vector<Need> needs_of_pictures(double best) {
    return {{"preview", "similarity of 0.9 or more",
             [](const MethodSummary& m) { return m.similarity >= similarity_of_preview; }},
            {"default", "similarity of 0.99 or more",
             [](const MethodSummary& m) { return m.similarity >= similarity_of_default; }},
            {"reference", "the greatest similarity",
             [best](const MethodSummary& m) { return m.similarity >= best; }}};
}

std::vector<Need> needs_of_methods(const TradeOffResult& result, double least_error) {
    std::vector<Need> needs{
        {"preview", "under 0.1 % faults in ordinary cases: " + result.measurements.front().family,
         [&](const MethodSummary& m) {
             return !m.faults || usual_faults(result, m.method) < faults_of_preview;
         }},
        {"default", "no fault in any family", is_faultless}};
    if (result.on_closed_mesh) {
        needs.push_back({"closed mesh", "no ray slipped through the closed mesh in any family",
                         [](const MethodSummary& m) { return m.faults && m.missed == 0; }});
    }
    needs.push_back(
        {"reference", "no fault, and the least error", [least_error](const MethodSummary& m) {
             return is_faultless(m) && m.error.value_or(0.0) <= least_error;
         }});
    return needs;
}

std::vector<std::string> cheapest(std::vector<MethodSummary> methods) {
    std::sort(methods.begin(), methods.end(), [](const MethodSummary& a, const MethodSummary& b) {
        return a.cost.median < b.cost.median;
    });
    std::vector<std::string> names;
    for (const MethodSummary& method : methods) {
        if (!is_cheaper(methods.front().cost, method.cost)) {
            names.push_back(method.method);
        }
    }
    return names;
}

} // namespace

std::vector<MethodSummary> summarize_methods(const TradeOffResult& result) {
    std::vector<MethodSummary> summaries;
    const double families = static_cast<double>(families_of(result).size());
    for (const std::string& method : methods_of(result)) {
        MethodSummary summary{method};
        for (const Measurement& one : result.measurements) {
            if (one.method == method) {
                add(summary, one);
            }
        }
        summary.cost = {summary.cost.median / families, summary.cost.lowest / families,
                        summary.cost.highest / families};
        summaries.push_back(std::move(summary));
    }
    return summaries;
}

bool dominates(const MethodSummary& a, const MethodSummary& b) {
    std::vector<int> orders{order_of(a.cost.lowest, a.cost.highest, b.cost.lowest, b.cost.highest)};
    if (a.faults && b.faults) {
        orders.push_back(
            order_of(a.faults->lowest, a.faults->highest, b.faults->lowest, b.faults->highest));
    }
    if (a.error && b.error) {
        orders.push_back(order_of(*a.error, *a.error, *b.error, *b.error));
    }
    return std::find(orders.begin(), orders.end(), 1) == orders.end() &&
           std::find(orders.begin(), orders.end(), -1) != orders.end();
}

bool is_dominated(const MethodSummary& method, std::span<const MethodSummary> all) {
    return std::any_of(all.begin(), all.end(),
                       [&](const MethodSummary& other) { return dominates(other, method); });
}

std::vector<Advice> advise(const TradeOffResult& result) {
    if ((result.kind != TradeOffKind::methods && result.kind != TradeOffKind::pictures) ||
        result.measurements.empty()) {
        return {};
    }
    const std::vector<MethodSummary> methods = summarize_methods(result);
    double best = 0.0;
    double least_error = 1e300;
    for (const MethodSummary& method : methods) {
        best = std::max(best, method.similarity);
        if (is_faultless(method) && method.error) {
            least_error = std::min(least_error, *method.error);
        }
    }
    std::vector<Advice> advice;
    for (const Need& need : result.kind == TradeOffKind::pictures
                                ? needs_of_pictures(best)
                                : needs_of_methods(result, least_error)) {
        std::vector<MethodSummary> fit;
        std::copy_if(methods.begin(), methods.end(), std::back_inserter(fit), need.is_met);
        advice.push_back({need.name, result.name,
                          fit.empty() ? std::vector<std::string>{} : cheapest(std::move(fit)),
                          need.condition});
    }
    return advice;
}

} // namespace raysteps
