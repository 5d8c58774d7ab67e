#include "knob.h"

#include <algorithm>

namespace raysteps {

namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
    }
}

} // namespace

std::vector<std::string> methods_of(const KnobResult& result) {
    std::vector<std::string> names;
    for (const Measurement& measurement : result.measurements) {
        add_once(names, measurement.method);
    }
    return names;
}

std::vector<std::string> families_of(const KnobResult& result) {
    std::vector<std::string> names;
    for (const Measurement& measurement : result.measurements) {
        add_once(names, measurement.family);
    }
    return names;
}

const Measurement* measurement_of(const KnobResult& result, const std::string& method,
                                  const std::string& family) {
    for (const Measurement& measurement : result.measurements) {
        if (measurement.method == method && measurement.family == family) {
            return &measurement;
        }
    }
    return nullptr;
}

} // namespace raysteps
