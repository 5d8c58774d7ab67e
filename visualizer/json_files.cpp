#include "json_files.h"

#include "basics/error.h"
#include "basics/file.h"
#include "state_fields.h"
#include "visualizer/replay/sentence.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <type_traits>

using Json = nlohmann::json;

template <glm::length_t count, class Number, glm::qualifier qualifier>
struct nlohmann::adl_serializer<glm::vec<count, Number, qualifier>> {
    static void to_json(Json& json, const glm::vec<count, Number, qualifier>& v) {
        for (glm::length_t i = 0; i < count; ++i) {
            json.push_back(v[i]);
        }
    }

    static void from_json(const Json& json, glm::vec<count, Number, qualifier>& v) {
        for (glm::length_t i = 0; i < count; ++i) {
            json.at(static_cast<std::size_t>(i)).get_to(v[i]);
        }
    }
};

namespace raysteps {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Camera, eye, target, up, vertical_field_of_view)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Ray, origin, direction, t_min, t_max)

} // namespace raysteps

namespace raysteps::view {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClipPlane, point, normal)

void to_json(Json& json, const Levels& levels) {
    json = {levels.lowest, levels.highest};
}

void from_json(const Json& json, Levels& levels) {
    levels = {json.at(0).get<int>(), json.at(1).get<int>()};
}

namespace {

template <class Value>
Json json_of(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        return word_of(value);
    } else {
        return value;
    }
}

// Null where there is none.
template <class Value>
Json json_of(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

// NLOHMANN_JSON_SERIALIZE_ENUM would take a word that does not exist for the first one.
template <class Value>
void take(const Json& json, Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        const Words words = words_of(value);
        const auto word = std::find(words.begin(), words.end(), json.get<std::string>());
        if (word == words.end()) {
            throw InputError("there is no choice " + json.dump());
        }
        value = static_cast<Value>(word - words.begin());
    } else {
        json.get_to(value);
    }
}

template <class Value>
void take(const Json& json, std::optional<Value>& value) {
    value = json.get<Value>();
}

void check(const State& state) {
    const auto fits = [](const glm::ivec2& size) {
        return size.x >= 1 && size.y >= 1 && size.x <= 16384 && size.y <= 16384;
    };
    if (!fits(state.picture) || !fits(state.window)) {
        throw InputError("`picture` and `window` are sizes in pixels, from 1 to 16384");
    }
    if (state.pixel && state.ray) {
        throw InputError("`pixel` and `ray` both name the ray");
    }
}

// More digits than a picture can show would only make the page slow.
double six_digits(float value) {
    return std::strtod(fmt::format("{:.6g}", static_cast<double>(value)).c_str(), nullptr);
}

Json point(const glm::vec3& place) {
    return {six_digits(place.x), six_digits(place.y), six_digits(place.z)};
}

Json corners_of(const Box& box) {
    return {point(box.lower), point(box.upper)};
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
            for (const Json& number : point(corner)) {
                points.push_back(number);
            }
        }
        triangles.push_back(entry->second);
    }
    file["points"] = points;
    file["triangles"] = triangles;
}

std::string outcome_word(Outcome outcome) {
    constexpr std::array words{"tested", "entered", "climbed", "emptied",
                               "missed", "behind",  "touched", "leaf"}; // in the order of Outcome
    return words.at(static_cast<std::size_t>(outcome));
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
        box = corners_of(pane.cells.cells[static_cast<std::size_t>(step.cell)].box);
    }
    return {{"sentence", sentence_of(pane.cells, walk, number)},
            {"outcome", outcome_word(step.outcome)},
            {"box", box},
            {"tested", tested},
            {"hit", hit}};
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

} // namespace

std::string state_text(const State& state) {
    nlohmann::ordered_json file;
    visit_fields([&](const Field& field, auto member) {
        if (const Json json = json_of(state.*member); !json.is_null()) {
            file[field.name] = json;
        }
    });
    return file.dump(2) + "\n";
}

State parse_state(const std::string& text, const std::string& name) {
    try {
        const Json file = Json::parse(text);
        if (!file.is_object() || !file.contains("structures")) {
            throw InputError("it has no field `structures`");
        }
        State state;
        visit_fields([&](const Field& field, auto member) {
            if (!file.contains(field.name)) {
                return;
            }
            try {
                take(file.at(field.name), state.*member);
            } catch (const std::exception& error) {
                throw InputError("`" + field.name + "` cannot be read: " + error.what());
            }
        });
        check(state);
        return state;
    } catch (const std::exception& error) {
        throw InputError(name + ": not a state of the visualizer: " + error.what() +
                         ". Save one with --save-state or the key K.");
    }
}

State read_state(const std::filesystem::path& path) {
    constexpr std::uintmax_t most_bytes = 1U << 20U;
    return parse_state(read_file(path, most_bytes), path.string());
}

void save_state(const std::filesystem::path& path, const State& state) {
    write_file(path, state_text(state));
}

void write_walk(const std::filesystem::path& path, const Stage& stage, const State& state) {
    const Pane& pane = *stage.panes().front();
    const RecordedWalk* const walk = walk_in(pane, state);
    if (!walk) {
        throw InputError("--export " + path.string() +
                         ": there is no ray, so there is no walk to write. Name a ray with --pixel "
                         "or --ray.");
    }
    Json file;
    file["structure"] = walk->structure;
    add_model(file, stage.scene());
    file["boxes"] = boxes_of(pane.cells);
    file["ray"] = {point(walk->ray.origin), point(end_of(stage, *walk))};
    file["steps"] = Json::array();
    for (std::size_t number = 0; number < walk->steps.size(); ++number) {
        file["steps"].push_back(step_of(pane, *walk, number));
    }
    file["ending"] = ending_of(*walk);
    write_file(path, file.dump() + "\n");
}

} // namespace raysteps::view
