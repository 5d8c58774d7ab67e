#include "pane.h"

#include "basics/error.h"
#include "basics/text.h"
#include "structure/structure.h"
#include "structure/tree_file/tree_file.h"

#include <algorithm>

namespace raysteps::view {

namespace {

using Values = std::map<std::string, std::string>;

// A structure as a state names it, taken apart.
struct StructureName {
    std::string structure;
    Values values;
};

// For a family, as in `kd`, its most common walk.
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

StructureName read_structure_name(const std::string& text) {
    const std::vector<std::string> words = split_words(text, ':');
    StructureName name{walk_named(words.front()), {}};
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t equals = words[i].find('=');
        if (equals == std::string::npos) {
            throw InputError("--structure " + text +
                             ": write an option of a structure as NAME=VALUE, as in "
                             "bvh_ordered:split=median.");
        }
        name.values[words[i].substr(0, equals)] = words[i].substr(equals + 1);
    }
    return name;
}

// Its own values, then those for all panes that its builder has, then those of the hard case.
Values values_for(const StructureName& name, const StructureFamily& family,
                  const PaneSource& source) {
    check_build_values(name.values, {{name.structure}});
    Values values = name.values;
    for (const BuildOption& option : family.options) {
        const auto given = source.build_values.find(option.name);
        if (given != source.build_values.end()) {
            values.insert(*given);
        }
    }
    if (const auto hard = source.hard_values.find(family.name); hard != source.hard_values.end()) {
        values.insert(hard->second.begin(), hard->second.end());
    }
    return values;
}

// The costs that the builder used; those of CellCosts for a builder without costs.
CellCosts costs_of(const StructureFamily& family, const Values& values) {
    CellCosts costs;
    for (const BuildOption& option : family.options) {
        const auto given = values.find(option.name);
        const auto number =
            parse_number<double>(given == values.end() ? option.initial : given->second);
        if (option.name == "traversal-cost") {
            costs.traversal = number.value_or(costs.traversal);
        } else if (option.name == "intersection-cost") {
            costs.intersection = number.value_or(costs.intersection);
        }
    }
    return costs;
}

// The tree of the file, where it is of boxes and these are walks through boxes.
std::optional<BoxTree> box_tree_of_file(const StructureFamily& family, const Values& values,
                                        std::span<const glm::vec3> corners) {
    const auto file = values.find("tree");
    if (file == values.end() || (family.name != "bvh" && family.name != "bvh4")) {
        return std::nullopt;
    }
    AnyTree tree = in_numbers_of(read_tree_file(file->second), corners);
    BoxTree* const boxes = std::get_if<BoxTree>(&tree);
    return boxes == nullptr ? std::nullopt : std::optional(std::move(*boxes));
}

// Knows no walk, but the answer of the loop over every triangle.
WalkRecorder recorder_of_answers(const WalkRecorder& loop) {
    WalkRecorder answers = loop;
    answers.record = [record = loop.record](const Ray& ray, Question question) {
        RecordedWalk walk = record(ray, question);
        walk.steps.clear();
        walk.tests.clear();
        walk.ending = Ending::no_walk;
        return walk;
    };
    return answers;
}

// Only the cells of the tree, with the sentence on why no walk goes through it.
void show_without_walk(Pane& pane, const PaneSource& source, const CellCosts& costs,
                       const std::string& refusal) {
    pane.refusal = refusal;
    pane.built = every_triangle(triangle_count(source.scene));
    pane.cells = cells_of(*pane.tree, costs);
    pane.recorder =
        recorder_of_answers(make_recorder("every_triangle", {source.buffers, pane.built.packed}));
}

std::unique_ptr<Pane> build_pane(const std::string& label, const PaneSource& source,
                                 const Say& say) {
    const StructureName name = read_structure_name(label);
    const StructureFamily family = family_of(name.structure);
    const Values values = values_for(name, family, source);
    auto pane = std::make_unique<Pane>();
    pane->label = label;
    pane->structure = name.structure;
    say("building " + label);
    pane->tree = box_tree_of_file(family, values, source.scene.corners);
    try {
        pane->built = family.build(source.scene.corners, {.reach = source.reach, .values = values});
    } catch (const InputError& error) {
        const bool fits = pane->tree && (pane->tree->width != 4 || family.name == "bvh4");
        if (!fits) {
            throw;
        }
        show_without_walk(*pane, source, costs_of(family, values), error.what());
        return pane;
    }
    pane->cells = cells_of(pane->built.packed, costs_of(family, values));
    pane->recorder = make_recorder(name.structure, {source.buffers, pane->built.packed});
    return pane;
}

} // namespace

std::vector<std::unique_ptr<Pane>> build_panes(const std::vector<std::string>& structures,
                                               const PaneSource& source, const Say& say) {
    if (structures.empty()) {
        throw InputError("--structure: no structure is named. Name one.");
    }
    std::vector<std::string> names;
    for (const std::string& label : structures) {
        names.push_back(read_structure_name(label).structure);
    }
    check_build_values(source.build_values, names);
    std::vector<std::unique_ptr<Pane>> panes;
    for (const std::string& label : structures) {
        panes.push_back(build_pane(label, source, say));
    }
    return panes;
}

const RecordedWalk* walk_in(const Pane& pane, const State& state) {
    if (pane.path.empty()) {
        return nullptr;
    }
    const int last = static_cast<int>(pane.path.size()) - 1;
    return &pane.path[static_cast<std::size_t>(std::clamp(state.path_ray, 0, last))].walk;
}

std::size_t step_in(const RecordedWalk& walk, const State& state) {
    if (walk.steps.empty()) {
        return 0;
    }
    const std::size_t last = walk.steps.size() - 1;
    return state.step < 0 ? last : std::min(static_cast<std::size_t>(state.step), last);
}

} // namespace raysteps::view
