#include "shader_line.h"

#include "basics/data_folder.h"
#include "basics/error.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace raysteps {

namespace {

namespace fs = std::filesystem;

// The words of a line, and how another walk may say the same.
using Words = std::vector<std::string>;

const Words nearer{"if (is_nearer(hit, nearest) &&", "if (is_nearer(hit, leaf.nearest) &&"};
const Words found_any{"found = hit.t <= near_enough;", "ended = hit.t <= near_enough;"};

const Words grid_leaves{"int axis = first_axis(leaves);"};
const Words grid_hit{"ended = nearest.t < leaves[axis] ||"};
const Words grid_outside{"ended = ended || i < 0 ||"};

const Words kd_side{"taken.child = t_split <= t ?"};
const Words kd_along{"taken.child = ray.origin[node.axis] <="};
const Words kd_ended{"visit.walk.ended = nearest.t < leaf.exit ||"};
const Words kd_climbs{"while (up.exit <= t &&"};
const Words kd_touches{"bool only_touched = leaf.exit <= t &&"};

const Words bvh_met{"bool met = meets_bvh_node(for_boxes, here, nearest.t);",
                    "bool met = entry <= spans.exit[child]"};
const Words bvh_entered{"node = met && !is_bvh_leaf(here) ?", "node = inside ? bvh_children(",
                        "node = children.near;", "place = choice.link;"};
const Words bvh_emptied{"if (choice.count == 0) {"};
const Words bvh_back{"seen = child == last ? spans.entry[child] : seen;"};
const Words box_missed{"return span.entry <= exit;", "return span.entry <= span.exit;",
                       "bool met = entry <= spans.exit[child]"};

Words grid_words(const RecordedWalk& walk, bool is_last) {
    if (!is_last) {
        return grid_leaves;
    }
    if (walk.ending == Ending::found) {
        return found_any;
    }
    return walk.ending == Ending::outside ? grid_outside : grid_hit;
}

Words kd_words(const RecordedWalk& walk, const Step& step, bool is_last) {
    switch (step.outcome) {
    case Outcome::climbed:
        return kd_climbs;
    case Outcome::touched:
        return kd_touches;
    case Outcome::entered:
        return walk.ray.direction[step.axis] == 0.0f ? kd_along : kd_side;
    default:
        return is_last && walk.ending == Ending::found ? found_any : kd_ended;
    }
}

Words bvh_words(const RecordedWalk& walk, const Step& step, bool is_last) {
    switch (step.outcome) {
    case Outcome::missed:
        return box_missed;
    case Outcome::behind:
        return bvh_met;
    case Outcome::entered:
        return bvh_entered;
    case Outcome::emptied:
        return bvh_emptied;
    case Outcome::climbed:
        return bvh_back;
    default:
        return is_last && walk.ending == Ending::found ? found_any : nearer;
    }
}

fs::path shader_folder() {
    return data_folder(RAYSTEPS_SHADER_DIR, "shaders");
}

// The file of a walk, from the shader folder, and the name of the folder that it is in.
fs::path file_of(const std::string& structure) {
    const fs::path root = shader_folder();
    for (const auto& entry : fs::recursive_directory_iterator(root / "structure")) {
        if (entry.path().filename() == structure + ".glsl") {
            return fs::relative(entry.path(), root);
        }
    }
    throw MachineError("shaders/structure: there is no file " + structure +
                       ".glsl. Restore it, or take another --structure.");
}

Words words_of(const RecordedWalk& walk, std::size_t number) {
    const Step& step = walk.steps.at(number);
    const bool is_last = number + 1 == walk.steps.size();
    const std::string folder = file_of(walk.structure).parent_path().filename();
    if (folder == "grid") {
        return grid_words(walk, is_last);
    }
    if (folder == "kd_tree") {
        return kd_words(walk, step, is_last);
    }
    if (folder == "bvh") {
        return bvh_words(walk, step, is_last);
    }
    return is_last && walk.ending == Ending::found ? found_any : nearer;
}

std::vector<std::string> lines_of(const fs::path& file) {
    std::ifstream stream(shader_folder() / file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

// A walk's file, then those that it includes.
std::vector<fs::path> files_of(const std::string& structure) {
    std::vector<fs::path> files{file_of(structure)};
    const std::string include = "#include \"";
    for (const std::string& line : lines_of(files.front())) {
        if (line.starts_with(include)) {
            files.emplace_back(line.substr(include.size(), line.rfind('"') - include.size()));
        }
    }
    return files;
}

// The number of the exercise that a line belongs to, from that of the line before it: marks stand
// around what a student writes.
std::string exercise_at(const std::string& line, const std::string& before) {
    const std::string begin = "//# exercise ";
    const std::size_t found = line.find(begin);
    if (found != std::string::npos) {
        const std::size_t number = found + begin.size();
        return line.substr(number, line.find(':', number) - number);
    }
    return line.find("//# end") != std::string::npos ? "" : before;
}

} // namespace

ShaderLine find_line(const std::string& structure, const std::vector<std::string>& words) {
    const std::vector<fs::path> files = files_of(structure);
    for (const std::string& wanted : words) {
        for (const fs::path& file : files) {
            ShaderLine found;
            int number = 0;
            int times = 0;
            std::string exercise;
            for (const std::string& line : lines_of(file)) {
                ++number;
                exercise = exercise_at(line, exercise);
                const bool is_stub = line.find("//# stub:") != std::string::npos; // of an exercise
                if (!is_stub && line.find(wanted) != std::string::npos) {
                    ++times;
                    found = {file, number, line.substr(line.find_first_not_of(' ')), exercise};
                }
            }
            if (times == 1) {
                return found;
            }
        }
    }
    throw MachineError("shaders/" + files.front().string() + ": no line with `" + words.front() +
                       "` stands there once, nor in a file that it includes. Restore the file, or "
                       "name its line in visualizer/replay/shader_line.cpp.");
}

ShaderLine deciding_line(const RecordedWalk& walk, std::size_t step) {
    Words words = words_of(walk, step);
    words.emplace_back("observe_visit(");
    return find_line(walk.structure, words);
}

} // namespace raysteps
