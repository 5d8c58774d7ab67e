#include "numbers.h"

namespace raysteps {

namespace {

Numbers fault_numbers(const Fault& fault) {
    const FaultRate rate = fault_rate(fault.count, fault.of);
    return {
        {"name", fault.name},          {"count", fault.count},       {"of", fault.of},
        {"per_million", rate.counted}, {"lower_bound", rate.lowest}, {"upper_bound", rate.highest}};
}

Numbers measurement_numbers(const Measurement& one) {
    Numbers numbers{{"method", one.method},           {"family", one.family},
                    {"timed_cases", one.timed_cases}, {"nanoseconds", one.cost.median},
                    {"lowest", one.cost.lowest},      {"highest", one.cost.highest},
                    {"faults", empty_list()}};
    for (const Fault& fault : one.findings.faults) {
        numbers["faults"].push_back(fault_numbers(fault));
    }
    if (one.findings.error) {
        numbers["error"] = {{"median", one.findings.error->median},
                            {"percentile_99", one.findings.error->percentile_99},
                            {"largest", one.findings.error->largest}};
    }
    for (const Measure& measure : one.findings.measures) {
        numbers[measure.name] = measure.value;
    }
    return numbers;
}

Numbers knob_numbers(const KnobResult& result) {
    Numbers methods = empty_list();
    const std::vector<MethodSummary> summaries = summarize_methods(result);
    for (const MethodSummary& method : summaries) {
        methods.push_back({{"method", method.method},
                           {"nanoseconds", method.cost.median},
                           {"dominated", is_dominated(method, summaries)}});
    }
    Numbers measurements = empty_list();
    for (const Measurement& one : result.measurements) {
        measurements.push_back(measurement_numbers(one));
    }
    return {{"knob", result.name},
            {"changes_only_speed", result.kind == KnobKind::speed_only},
            {"unit_of_cases", result.unit_of_cases},
            {"unit_of_error", result.unit_of_error},
            {"methods", methods},
            {"measurements", measurements}};
}

} // namespace

Numbers to_numbers(const AccuracyReport& report) {
    Numbers circumstances = empty_object();
    for (const auto& [name, value] : report.circumstances) {
        circumstances[name] = value;
    }
    Numbers advice = empty_list();
    for (const Advice& one : report.advice) {
        advice.push_back({{"knob", one.knob},
                          {"need", one.need},
                          {"condition", one.condition},
                          {"methods", one.methods}});
    }
    Numbers knobs = empty_list();
    for (const KnobResult& result : report.results) {
        knobs.push_back(knob_numbers(result));
    }
    return {{"scene", report.scene},
            {"circumstances", circumstances},
            {"scene_needs", report.scene_needs},
            {"advice", advice},
            {"knobs", knobs}};
}

} // namespace raysteps
