#include "tables.h"

#include "basics/text.h"
#include "fault_rate.h"

#include <fmt/core.h>

namespace raysteps {

namespace {

std::string faults_of(const Findings& findings) {
    std::string text;
    for (const Fault& fault : findings.faults) {
        text += fmt::format("  {} {}", fault.name, to_string(fault_rate(fault.count, fault.of)));
    }
    return text;
}

std::string measures_of(const Findings& findings, const std::string& between) {
    std::string text;
    for (const Measure& measure : findings.measures) {
        text += between + fmt::format("{} {:.6g}", measure.name, measure.value);
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
            table += fmt::format("    {:26} {:8.4g} ns a {} ({:.4g} to {:.4g})", one.method,
                                 one.cost.median, result.unit_of_cases, one.cost.lowest,
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
            csv += csv_field(result.name) + "," + csv_field(one.family) + "," +
                   csv_field(one.method) +
                   fmt::format(",{},{:.9g},{:.9g},{:.9g},", one.timed_cases, one.cost.median,
                               one.cost.lowest, one.cost.highest);
            csv += total.of == 0 ? ",,,,,"
                                 : fmt::format("{},{},{:.9g},{:.9g},{:.9g},", total.count, total.of,
                                               rate.counted, rate.lowest, rate.highest);
            const auto& error = one.findings.error;
            csv += error ? fmt::format("{:.9g},{:.9g},{:.9g},", error->median, error->percentile_99,
                                       error->largest)
                         : ",,,";
            csv += csv_field(result.unit_of_error) + "," +
                   csv_field(measures_of(one.findings, "; ")) + "\n";
        }
    }
    return csv;
}

} // namespace raysteps
