#include "walk_file.h"

#include "basics/error.h"
#include "basics/file.h"
#include "visualizer/replay/sentence.h"
#include "walk_words.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

namespace raysteps::view {

namespace {

using Json = nlohmann::json;

// More digits than a picture can show would only make the page slow.
double six_digits(float value) {
    return std::strtod(fmt::format("{:.6g}", static_cast<double>(value)).c_str(), nullptr);
}

Json drawn_point(const glm::vec3& place) {
    return {six_digits(place.x), six_digits(place.y), six_digits(place.z)};
}

Json corners_of(const Box& box) {
    return {drawn_point(box.lower), drawn_point(box.upper)};
}

// Bit for bit; JSON has neither NaN nor infinity.
Json number(float value) {
    if (std::isfinite(value)) {
        return value;
    }
    if (std::isnan(value)) {
        return "nan";
    }
    return value > 0.0f ? "infinity" : "-infinity";
}

Json point(const glm::vec3& place) {
    return {number(place.x), number(place.y), number(place.z)};
}

Json hit_json(const Hit& hit) {
    if (hit.triangle == no_triangle) {
        return nullptr;
    }
    return {{"t", number(hit.t)},
            {"u", number(hit.u)},
            {"v", number(hit.v)},
            {"triangle", hit.triangle}};
}

// Triangles share their corners: storing each once takes a third of the numbers.
void add_model(Json& file, const Scene& scene) {
    std::map<std::array<float, 3>, std::size_t> indices;
    Json points = Json::array();
    Json triangles = Json::array();
    for (const glm::vec3& corner : scene.corners) {
        const auto [entry, is_new] =
            indices.try_emplace({corner.x, corner.y, corner.z}, indices.size());
        if (is_new) {
            for (const Json& coordinate : drawn_point(corner)) {
                points.push_back(coordinate);
            }
        }
        triangles.push_back(entry->second);
    }
    file["points"] = points;
    file["triangles"] = triangles;
}

Json step_json(const Pane& pane, const RecordedWalk& walk, std::size_t place) {
    const Step& step = walk.steps[place];
    Json tested = Json::array();
    Json hits = Json::array();
    for (const TriangleTest& test : tests_of(walk, step)) {
        tested.push_back(test.triangle);
        if (test.hit.triangle != no_triangle) {
            hits.push_back(test.triangle);
        }
    }
    Json box = nullptr;
    if (step.cell != no_cell) {
        box = corners_of(pane.cells.cells[static_cast<std::size_t>(step.cell)].box);
    }
    Json json{{"place", step.place},
              {"outcome", outcome_words.at(static_cast<std::size_t>(step.outcome))},
              {"box", box},
              {"tested", tested},
              {"hits", hits},
              {"nearest", hit_json(step.nearest)},
              {"sentence", sentence_of(pane.cells, walk, place)}};
    if (step.round > 0) {
        json["round"] = step.round;
    }
    return json;
}

Json boxes_of(const StructureCells& structure) {
    Json boxes = Json::array();
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
    if (!walk) {
        throw InputError("--export " + path.string() +
                         ": there is no ray, so there is no walk to write. Name a ray with --pixel "
                         "or --ray.");
    }
    Json file;
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
    file["steps"] = Json::array();
    for (std::size_t place = 0; place < walk->steps.size(); ++place) {
        file["steps"].push_back(step_json(pane, *walk, place));
    }
    file["ended"] = walk->ending != Ending::cut;
    file["hit"] = hit_json(walk->hit);
    file["ending"] = ending_of(*walk);
    add_model(file, stage.scene());
    file["boxes"] = boxes_of(pane.cells);
    file["line"] = {drawn_point(walk->ray.origin), drawn_point(end_of(stage, *walk))};
    write_file(path, file.dump() + "\n");
}

} // namespace raysteps::view
