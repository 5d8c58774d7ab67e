#include "trials.h"

#include "basics/error.h"
#include "basics/text.h"
#include "hard_cases/hard_cases.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace raysteps {

namespace {

constexpr std::string_view sections = "PTBGKVDSEFL";

Trial to_trial(const HardCase& hard_case) {
    return {hard_case.name, hard_case.title, hard_case.source, hard_case.remedy,
            [hard_case](const TrialTools& tools) { return run_hard_case(hard_case, tools); }};
}

// T10 comes after T9, and T10z after T10.
bool comes_before(const Trial& a, const Trial& b) {
    const auto place = [](const Trial& trial) {
        const int number = std::atoi(trial.name.c_str() + 1);
        return std::pair{sections.find(trial.name[0]), number};
    };
    return place(a) < place(b);
}

std::vector<Trial> join_lists() {
    std::vector<Trial> all;
    for (const HardCase& hard_case : hard_cases()) {
        all.push_back(to_trial(hard_case));
    }
    for (const auto list :
         {paper_checks, triangle_checks, box_checks, grid_checks, tree_checks, surface_checks,
          effect_checks, glass_checks, file_checks, platform_checks}) {
        for (Trial& trial : list()) {
            all.push_back(std::move(trial));
        }
    }
    std::stable_sort(all.begin(), all.end(), comes_before);
    return all;
}

std::string in_capitals(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    return text;
}

} // namespace

const std::vector<Trial>& all_trials() {
    static const std::vector<Trial> all = join_lists();
    return all;
}

const Trial& find_trial(const std::string& name) {
    std::vector<std::string_view> names;
    for (const Trial& trial : all_trials()) {
        if (in_capitals(trial.name) == in_capitals(name)) {
            return trial;
        }
        names.emplace_back(trial.name);
    }
    throw InputError(no_such_choice("--case", name, "hard case", names));
}

std::vector<Trial> leak_trials() {
    std::vector<Trial> trials;
    for (const char* name : {"T1", "T2"}) {
        HardCase hard_case = find_hard_case(name);
        hard_case.tries = Tries::structures;
        trials.push_back(to_trial(hard_case));
    }
    return trials;
}

} // namespace raysteps
