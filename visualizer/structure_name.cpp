#include "structure_name.h"

#include "basics/error.h"
#include "basics/text.h"
#include "visualizer/replay/walk_recorder.h"
#include "structure/structure.h"

#include <algorithm>

namespace raysteps::view {

namespace {

// Of a family, as in `kd`, the first of its walks.
std::string walk_named(const std::string& name) {
    const std::vector<std::string> names = recorded_structures();
    if (std::find(names.begin(), names.end(), name) != names.end()) {
        return name;
    }
    for (const std::string usual : {"bvh_ordered", "kd_ropes"}) {
        if (usual.starts_with(name + "_")) {
            return usual;
        }
    }
    std::string all;
    for (const std::string& known : names) {
        all += (all.empty() ? "" : ", ") + known;
    }
    throw InputError("--structure " + name + ": there is no such structure. Take one of " + all +
                     ".");
}

double number_in(const std::string& text, double otherwise) {
    return parse_number<double>(text).value_or(otherwise);
}

} // namespace

StructureName read_structure_name(const std::string& text) {
    const std::vector<std::string> words = split_words(text, ':');
    StructureName name{walk_named(words.front()), {}};
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t equals = words[i].find('=');
        if (equals == std::string::npos) {
            throw InputError("--structure " + text +
                             ": an option of a structure is NAME=VALUE, as in "
                             "bvh_ordered:split=median.");
        }
        name.values[words[i].substr(0, equals)] = words[i].substr(equals + 1);
    }
    return name;
}

std::map<std::string, std::string> values_for(const StructureName& name, const State& state) {
    check_build_values(name.values, {{name.structure}});
    std::map<std::string, std::string> values = name.values;
    for (const BuildOption& option : family_of(name.structure).options) {
        const auto given = state.build_values.find(option.name);
        if (given != state.build_values.end()) {
            values.try_emplace(option.name, given->second);
        }
    }
    return values;
}

CellCosts costs_of(const StructureFamily& family,
                   const std::map<std::string, std::string>& values) {
    CellCosts costs;
    for (const BuildOption& option : family.options) {
        const auto given = values.find(option.name);
        const std::string text = given == values.end() ? option.initial : given->second;
        if (option.name == "traversal-cost") {
            costs.traversal = number_in(text, costs.traversal);
        } else if (option.name == "intersection-cost") {
            costs.intersection = number_in(text, costs.intersection);
        }
    }
    return costs;
}

} // namespace raysteps::view
