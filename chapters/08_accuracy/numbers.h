#pragma once

#include "page.h"
#include "program/deliver.h"

namespace raysteps {

// The report for programs.
nlohmann::ordered_json to_json(const AccuracyReport& report);

} // namespace raysteps
