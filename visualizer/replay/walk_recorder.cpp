#include "walk_recorder.h"

#include "basics/error.h"
#include "recorders.h"

#include <map>

namespace raysteps {

namespace {

using MakeRecorder = WalkRecorder (*)(const RecorderInput&);

const std::map<std::string, MakeRecorder>& recorders() {
    static const std::map<std::string, MakeRecorder> all{
        {"every_triangle", record_every_triangle},
        {"grid", record_grid},
        {"grid_mailbox", record_grid_mailbox},
        {"kd_restart", record_kd_restart},
        {"kd_backtrack", record_kd_backtrack},
        {"kd_short_stack", record_kd_short_stack},
        {"kd_ropes", record_kd_ropes},
        {"bvh_skip", record_bvh_skip},
        {"bvh_skip_padded", record_bvh_skip_padded},
        {"bvh_ordered", record_bvh_ordered},
        {"bvh_parent", record_bvh_parent},
        {"bvh_stack", record_bvh_stack},
    };
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
