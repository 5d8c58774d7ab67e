#include "walk_file.h"

#include "basics/error.h"
#include "basics/file.h"
#include "basics/numbers.h"
#include "visualizer/replay/sentence.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

namespace raysteps::view {

namespace {

constexpr auto walk_schema = "walk.schema.json";
constexpr int walk_schema_version = 1;
constexpr std::uintmax_t most_bytes = 1U << 28U;

// In the order of Outcome.
constexpr std::array outcome_words{"tested", "entered", "climbed", "emptied",
                                   "missed", "behind",  "touched", "leaf"};

// In the order of Question.
constexpr std::array question_words{"nearest", "any"};

// More digits than a picture can show would only make the page slow.
double six_digits(float value) {
    return std::strtod(fmt::format("{:.6g}", static_cast<double>(value)).c_str(), nullptr);
}

Numbers drawn_point(const glm::vec3& place) {
    return Numbers::List{six_digits(place.x), six_digits(place.y), six_digits(place.z)};
}

Numbers corners_of(const Box& box) {
    return Numbers::List{drawn_point(box.lower), drawn_point(box.upper)};
}

// Bit for bit; JSON has neither NaN nor infinity.
Numbers number(float value) {
    if (std::isfinite(value)) {
        return value;
    }
    if (std::isnan(value)) {
        return "nan";
    }
    return value > 0.0f ? "infinity" : "-infinity";
}

Numbers point(const glm::vec3& place) {
    return Numbers::List{number(place.x), number(place.y), number(place.z)};
}

Numbers numbers_of(const Hit& hit) {
    if (hit.triangle == no_triangle) {
        return {};
    }
    return {{"t", number(hit.t)},
            {"u", number(hit.u)},
            {"v", number(hit.v)},
            {"triangle", hit.triangle}};
}

// Triangles share their corners: storing each once takes a third of the numbers.
void add_model(Numbers& file, const Scene& scene) {
    std::map<std::array<float, 3>, std::size_t> indices;
    Numbers points = empty_list();
    Numbers triangles = empty_list();
    for (const glm::vec3& corner : scene.corners) {
        const auto [entry, is_new] =
            indices.try_emplace({corner.x, corner.y, corner.z}, indices.size());
        if (is_new) {
            for (int axis = 0; axis < 3; ++axis) {
                points.push_back(six_digits(corner[axis]));
            }
        }
        triangles.push_back(entry->second);
    }
    file["points"] = points;
    file["triangles"] = triangles;
}

Numbers numbers_of_step(const Pane& pane, const RecordedWalk& walk, std::size_t place) {
    const Step& step = walk.steps[place];
    Numbers tested = empty_list();
    Numbers hits = empty_list();
    for (const TriangleTest& test : tests_of(walk, step)) {
        tested.push_back(test.triangle);
        if (test.hit.triangle != no_triangle) {
            hits.push_back(test.triangle);
        }
    }
    Numbers box; // nothing
    if (step.cell != no_cell) {
        box = corners_of(pane.cells.cells[static_cast<std::size_t>(step.cell)].box);
    }
    Numbers told{{"place", step.place},
                 {"outcome", outcome_words.at(static_cast<std::size_t>(step.outcome))},
                 {"box", box},
                 {"tested", tested},
                 {"hits", hits},
                 {"nearest", numbers_of(step.nearest)},
                 {"sentence", sentence_of(pane.cells, walk, place)}};
    if (step.round > 0) {
        told["round"] = step.round;
    }
    return told;
}

Numbers boxes_of(const StructureCells& structure) {
    Numbers boxes = empty_list();
    for (const Cell& cell : structure.cells) {
        if (cell.triangles > 0) {
            boxes.push_back(corners_of(cell.box));
        }
    }
    return boxes;
}

// A ray that hits nothing is drawn a little beyond the box of the scene.
glm::vec3 end_of(const Stage& stage, const RecordedWalk& walk) {
    const Ray& ray = walk.ray;
    if (walk.hit.triangle != no_triangle) {
        return ray.origin + walk.hit.t * ray.direction;
    }
    const Box& bounds = stage.bounds();
    const float far_enough = glm::distance(ray.origin, 0.5f * (bounds.lower + bounds.upper)) +
                             glm::distance(bounds.lower, bounds.upper);
    return ray.origin + far_enough * glm::normalize(ray.direction);
}

// With the builder's options that hold for all panes.
std::string full_label(const Pane& pane, const State& state) {
    std::string label = pane.label;
    for (const BuildOption& option : family_of(pane.structure).options) {
        const auto given = state.build_values.find(option.name);
        if (given != state.build_values.end() &&
            label.find(":" + option.name + "=") == std::string::npos) {
            label += ":" + option.name + "=" + given->second;
        }
    }
    return label;
}

} // namespace

void write_walk(const std::filesystem::path& path, const Stage& stage, const State& state) {
    const Pane& pane = *stage.panes().front();
    const RecordedWalk* const walk = walk_in(pane, state);
    if (!pane.refusal.empty()) {
        throw InputError("--export " + path.string() + ": " + pane.refusal);
    }
    if (!walk) {
        throw InputError("--export " + path.string() +
                         ": there is no ray, so there is no walk to write. Name a ray with --pixel "
                         "or --ray.");
    }
    Numbers file;
    file["schema"] = walk_schema;
    file["schema_version"] = walk_schema_version;
    file["name"] = pane.label;
    file["structure"] = full_label(pane, state);
    if (state.hard_case.empty()) {
        file["scene"] = state.scene;
    }
    file["ray"] = {{"origin", point(walk->ray.origin)},
                   {"direction", point(walk->ray.direction)},
                   {"t_min", number(walk->ray.t_min)},
                   {"t_max", number(walk->ray.t_max)}};
    file["question"] = question_words.at(static_cast<std::size_t>(walk->question));
    Numbers steps = empty_list();
    for (std::size_t place = 0; place < walk->steps.size(); ++place) {
        steps.push_back(numbers_of_step(pane, *walk, place));
    }
    file["steps"] = steps;
    file["ended"] = walk->ending != Ending::cut;
    file["hit"] = numbers_of(walk->hit);
    file["ending"] = ending_of(*walk);
    add_model(file, stage.scene());
    file["boxes"] = boxes_of(pane.cells);
    file["line"] = Numbers::List{drawn_point(walk->ray.origin), drawn_point(end_of(stage, *walk))};
    write_file(path, file.to_json_line() + "\n");
}

namespace {

// JSON has neither NaN nor infinity.
float float_of(const Numbers& told) {
    const auto* const word = std::get_if<std::string>(&told.value());
    if (word == nullptr) {
        return static_cast<float>(told.number());
    }
    if (*word == "nan") {
        return std::numeric_limits<float>::quiet_NaN();
    }
    if (*word != "infinity" && *word != "-infinity") {
        throw InputError("`" + *word + "` is no number");
    }
    const float infinity = std::numeric_limits<float>::infinity();
    return *word == "infinity" ? infinity : -infinity;
}

int whole_of(const Numbers& told) {
    const double number = told.number();
    if (!(std::abs(number) <= std::numeric_limits<int>::max()) || number != std::trunc(number)) {
        throw InputError("`" + told.to_json() + "` is no whole number that an int can hold");
    }
    return static_cast<int>(number);
}

bool is_nothing(const Numbers& told) {
    return std::holds_alternative<std::monostate>(told.value());
}

glm::vec3 point_of(const Numbers& told) {
    const Numbers::List& values = told.values();
    if (values.size() != 3) {
        throw InputError("a point has three numbers");
    }
    return {float_of(values[0]), float_of(values[1]), float_of(values[2])};
}

Hit hit_of(const Numbers& told, const Ray& ray) {
    if (is_nothing(told)) {
        return {ray.t_max, 0.0f, 0.0f, no_triangle};
    }
    return {float_of(told.at("t")), float_of(told.at("u")), float_of(told.at("v")),
            whole_of(told.at("triangle"))};
}

template <class Choice, std::size_t count>
Choice choice_of(const Numbers& told, const std::array<const char*, count>& words) {
    const auto word = std::find(words.begin(), words.end(), told.text());
    if (word == words.end()) {
        throw InputError("there is no choice " + told.to_json());
    }
    return static_cast<Choice>(word - words.begin());
}

ToldStep step_of(const Numbers& told, const Ray& ray) {
    ToldStep step;
    step.place = whole_of(told.at("place"));
    if (const Numbers* const round = told.find("round")) {
        step.round = whole_of(*round);
    }
    for (const Numbers& triangle : told.at("tested").values()) {
        step.tested.push_back(whole_of(triangle));
    }
    step.nearest = hit_of(told.at("nearest"), ray);
    if (const Numbers* const outcome = told.find("outcome")) {
        step.outcome = choice_of<Outcome>(*outcome, outcome_words);
    }
    const Numbers* const box = told.find("box");
    if (box != nullptr && !is_nothing(*box)) {
        const Numbers::List& corners = box->values();
        if (corners.size() != 2) {
            throw InputError("a box has two corners");
        }
        step.box = Box{point_of(corners[0]), point_of(corners[1])};
    }
    return step;
}

ToldWalk walk_of(const Numbers& told) {
    if (told.at("schema").text() != walk_schema ||
        whole_of(told.at("schema_version")) != walk_schema_version) {
        throw InputError("its schema is another");
    }
    ToldWalk walk;
    walk.name = told.at("name").text();
    if (const Numbers* const scene = told.find("scene")) {
        walk.scene = scene->text();
    }
    walk.structure = told.at("structure").text();
    const Numbers& ray = told.at("ray");
    walk.ray = {point_of(ray.at("origin")), point_of(ray.at("direction")),
                float_of(ray.at("t_min")), float_of(ray.at("t_max"))};
    walk.question = choice_of<Question>(told.at("question"), question_words);
    for (const Numbers& step : told.at("steps").values()) {
        walk.steps.push_back(step_of(step, walk.ray));
    }
    const bool* const ended = std::get_if<bool>(&told.at("ended").value());
    if (ended == nullptr) {
        throw InputError("`ended` is true or false");
    }
    walk.ended = *ended;
    walk.hit = hit_of(told.at("hit"), walk.ray);
    return walk;
}

} // namespace

ToldWalk read_told_walk(const std::filesystem::path& path) {
    const std::string text = read_file(path, most_bytes);
    try {
        return walk_of(parse_json(text, path));
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": is no file of recorded steps (" + error.what() +
                         "). Write it as visualizer/" + walk_schema + " says.");
    }
}

} // namespace raysteps::view
