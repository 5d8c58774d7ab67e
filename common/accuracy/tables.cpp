#include "accuracy/tables.h"

#include "accuracy/fault_rate.h"

#include <cstdio>

namespace raysteps {

namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string in_quotes(const std::string& text) {
    std::string field = "\"";
    for (const char letter : text) {
        field += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return field + "\"";
}

std::string faults_of(const Findings& findings) {
    std::string text;
    for (const Fault& fault : findings.faults) {
        text += format("  %s %s", fault.name.c_str(),
                       to_string(fault_rate(fault.count, fault.of)).c_str());
    }
    return text;
}

std::string measures_of(const Findings& findings, const std::string& between) {
    std::string text;
    for (const Measure& measure : findings.measures) {
        text += between + format("%s %.6g", measure.name.c_str(), measure.value);
    }
    return text;
}

} // namespace

std::string to_table(const KnobResult& result) {
    std::string table = "\n" + result.name + ": " + result.question + "\n";
    table += "faults are per million cases, with 95 % bounds" +
             (result.unit_of_error.empty() ? "" : "; error of " + result.unit_of_error) + "\n";
    for (const std::string& family : families_of(result)) {
        table += "  " + family + "\n";
        for (const Measurement& one : result.measurements) {
            if (one.family != family) {
                continue;
            }
            table += format("    %-26s %8.4g ns a %s (%.4g to %.4g)", one.method.c_str(),
                            one.cost.median, result.unit_of_cases.c_str(), one.cost.lowest,
                            one.cost.highest);
            table += faults_of(one.findings);
            if (one.findings.error) {
                table += "  error " + to_string(*one.findings.error);
            }
            table += measures_of(one.findings, "  ") + "\n";
        }
    }
    return table;
}

std::string to_csv(std::span<const KnobResult> results) {
    std::string csv = "knob,family,method,timed_cases,nanoseconds,lowest,highest,faults,of,"
                      "per_million,lower_bound,upper_bound,error_median,error_99,error_largest,"
                      "unit_of_error,measures\n";
    for (const KnobResult& result : results) {
        for (const Measurement& one : result.measurements) {
            const Fault total = total_fault(one.findings);
            const FaultRate rate = fault_rate(total.count, total.of);
            csv += in_quotes(result.name) + "," + in_quotes(one.family) + "," +
                   in_quotes(one.method) +
                   format(",%zu,%.9g,%.9g,%.9g,", one.timed_cases, one.cost.median, one.cost.lowest,
                          one.cost.highest);
            csv += total.of == 0 ? ",,,,,"
                                 : format("%zu,%zu,%.9g,%.9g,%.9g,", total.count, total.of,
                                          rate.counted, rate.lowest, rate.highest);
            const auto& error = one.findings.error;
            csv += error ? format("%.9g,%.9g,%.9g,", error->median, error->percentile_99,
                                  error->largest)
                         : ",,,";
            csv += in_quotes(result.unit_of_error) + "," +
                   in_quotes(measures_of(one.findings, "; ")) + "\n";
        }
    }
    return csv;
}

} // namespace raysteps
