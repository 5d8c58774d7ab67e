#pragma once

#include "knob.h"

#include <string>

namespace raysteps {

// How often something happens, in millionths: as it was counted, and between which bounds the truth
// lies with a confidence of 95 %.
struct FaultRate {
    double counted = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
};

// Of 0 in n the upper bound is 3 / n (Hanley and Lippman-Hand, "If Nothing Goes Wrong, Is
// Everything All Right?", 1983); else the bounds are Wilson's ("Probable Inference, the Law of
// Succession, and Statistical Inference", 1927). Of no case at all nothing is known: 0 to a
// million.
FaultRate fault_rate(std::size_t count, std::size_t of);

// `0 (<183)`, `101637 (101045 to 102232)`: per million.
std::string to_string(const FaultRate& rate);

// All faults of the findings together; each case has at most one.
Fault total_fault(const Findings& findings);

} // namespace raysteps
