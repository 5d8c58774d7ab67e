#pragma once

#include "knob.h"
#include "verdict.h"

#include <string>
#include <utility>
#include <vector>

namespace raysteps {

// All that a report says.
struct AccuracyReport {
    std::string scene;
    std::vector<std::pair<std::string, std::string>> circumstances{}; // renderer, seed, commit ...
    std::vector<std::string> scene_needs{};                           // sentences
    std::vector<KnobResult> results{};
    std::vector<Advice> advice{};
};

// A picture of a report, as the bytes of a PNG file.
struct PagePicture {
    std::string knob;
    std::string caption;
    std::string png;
};

// The report as one HTML file that needs no other: advice, then each knob with its plots, table and
// pictures. Knobs that change only the speed come last.
std::string to_html(const AccuracyReport& report, const std::vector<PagePicture>& pictures);

} // namespace raysteps
