#include "fault_rate.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

constexpr double million = 1e6;
constexpr double normal_95 = 1.959963984540054; // 97.5 % of a normal distribution lie below
constexpr double rule_of_three = 3.0;           // -ln 0.05

} // namespace

FaultRate fault_rate(std::size_t count, std::size_t of) {
    if (of == 0) {
        return {0.0, 0.0, million};
    }
    const double n = static_cast<double>(of);
    const double share = static_cast<double>(count) / n;
    if (count == 0) {
        return {0.0, 0.0, std::min(1.0, rule_of_three / n) * million};
    }
    const double z2 = normal_95 * normal_95;
    const double center = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
    const double half =
        normal_95 / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
    return {share * million, std::max(0.0, center - half) * million,
            std::min(1.0, center + half) * million};
}

std::string to_string(const FaultRate& rate) {
    if (rate.counted == 0.0) {
        return fmt::format("0 (<{:.0f})", std::ceil(rate.highest));
    }
    return fmt::format("{:.0f} ({:.0f} to {:.0f})", rate.counted, rate.lowest, rate.highest);
}

Fault total_fault(const Findings& findings) {
    Fault total{"faults", 0, 0};
    for (const Fault& fault : findings.faults) {
        total.count += fault.count;
        total.of = std::max(total.of, fault.of);
    }
    return total;
}

} // namespace raysteps
