#include "walk_recorder.h"

#include "basics/error.h"
#include "record_with.h"

namespace raysteps {

namespace {

const Recorders& recorders() {
    static const Recorders all = [] {
        Recorders found = loop_recorders();
        for (Recorders more : {grid_recorders(), kd_tree_recorders(), bvh_recorders()}) {
            found.merge(more);
        }
        return found;
    }();
    return all;
}

} // namespace

WalkRecorder make_recorder(const std::string& structure, const RecorderInput& input) {
    const auto place = recorders().find(structure);
    if (place == recorders().end()) {
        std::string names;
        for (const std::string& name : recorded_structures()) {
            names += (names.empty() ? "" : ", ") + name;
        }
        throw InputError("--structure " + structure +
                         ": no walk of that name can be recorded. Take one of " + names + ".");
    }
    WalkRecorder recorder = place->second(input);
    recorder.structure = structure;
    recorder.record = [structure, record = recorder.record](const Ray& ray, Question question) {
        RecordedWalk walk = record(ray, question);
        walk.structure = structure;
        return walk;
    };
    recorder.explain = [structure, explain = recorder.explain](const ToldWalk& told) {
        RecordedWalk walk = explain(told);
        walk.structure = structure;
        return walk;
    };
    return recorder;
}

std::vector<std::string> recorded_structures() {
    std::vector<std::string> names;
    for (const auto& [name, make] : recorders()) {
        names.push_back(name);
    }
    return names;
}

} // namespace raysteps
