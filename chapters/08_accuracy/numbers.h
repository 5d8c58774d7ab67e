#pragma once

#include "page.h"
#include "program/output.h"

namespace raysteps {

// The report for programs.
Numbers to_numbers(const AccuracyReport& report);

} // namespace raysteps
