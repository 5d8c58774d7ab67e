#pragma once

#include "accuracy/page.h"
#include "command/deliver.h"

namespace raysteps {

// The report for programs.
nlohmann::ordered_json to_json(const AccuracyReport& report);

} // namespace raysteps
