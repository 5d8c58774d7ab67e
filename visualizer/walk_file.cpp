#include "walk_file.h"

#include "basics/error.h"
#include "visualizer/replay/sentence.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

namespace raysteps::view {

namespace {

using Json = nlohmann::json;

// More digits than a picture can show would only make the page slow.
double six_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return std::strtod(text, nullptr);
}

Json point(const glm::vec3& place) {
    return {six_digits(place.x), six_digits(place.y), six_digits(place.z)};
}

// Triangles share the points in which they meet: a third of the numbers are enough.
void add_model(Json& file, const Scene& scene) {
    std::map<std::array<float, 3>, std::size_t> places;
    Json points = Json::array();
    Json corners = Json::array();
    for (const glm::vec3& corner : scene.corners) {
        const auto [entry, is_new] =
            places.try_emplace({corner.x, corner.y, corner.z}, places.size());
        if (is_new) {
            for (const Json& number : point(corner)) {
                points.push_back(number);
            }
        }
        corners.push_back(entry->second);
    }
    file["points"] = points;
    file["triangles"] = corners;
}

std::string word_of(Outcome outcome) {
    switch (outcome) {
    case Outcome::tested:
        return "tested";
    case Outcome::entered:
        return "entered";
    case Outcome::climbed:
        return "climbed";
    case Outcome::missed:
        return "missed";
    case Outcome::behind:
        return "behind";
    case Outcome::touched:
        return "touched";
    case Outcome::leaf:
        return "leaf";
    }
    return "";
}

Json step_of(const Pane& pane, const RecordedWalk& walk, std::size_t number) {
    const Step& step = walk.steps[number];
    Json tested = Json::array();
    Json hit = Json::array();
    for (const TriangleTest& test : tests_of(walk, step)) {
        (test.hit.triangle == no_triangle ? tested : hit).push_back(test.triangle);
    }
    Json box = nullptr;
    if (step.cell != no_cell) {
        const Box& cell = pane.cells.cells[static_cast<std::size_t>(step.cell)].box;
        box = {point(cell.lower), point(cell.upper)};
    }
    return {{"sentence", sentence_of(pane.cells, walk, number)},
            {"outcome", word_of(step.outcome)},
            {"box", box},
            {"tested", tested},
            {"hit", hit}};
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

} // namespace

void write_walk(const std::filesystem::path& path, const Stage& stage, const State& state) {
    const Pane& pane = *stage.panes().front();
    const RecordedWalk* const walk = walk_in(pane, state);
    if (!walk) {
        throw InputError("--export " + path.string() +
                         ": there is no ray whose walk could be written. Name one with --pixel "
                         "or --ray.");
    }
    Json file;
    file["structure"] = walk->structure;
    add_model(file, stage.scene());
    file["ray"] = {point(walk->ray.origin), point(end_of(stage, *walk))};
    file["steps"] = Json::array();
    for (std::size_t number = 0; number < walk->steps.size(); ++number) {
        file["steps"].push_back(step_of(pane, *walk, number));
    }
    file["ending"] = ending_of(*walk);
    std::ofstream out(path);
    out << file.dump() << "\n";
    if (!out.flush()) {
        throw InputError("--export " + path.string() +
                         ": the file cannot be written. Name another place.");
    }
}

} // namespace raysteps::view
