#include "state_file.h"

#include "basics/error.h"
#include "basics/file.h"
#include "state_words.h"

#include <nlohmann/json.hpp>

namespace raysteps::view {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

glm::vec3 vector_in(const Json& json) {
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

Json to_json(const glm::ivec2& v) {
    return {v.x, v.y};
}

glm::ivec2 pair_in(const Json& json) {
    return {json.at(0).get<int>(), json.at(1).get<int>()};
}

Json to_json(const Camera& camera) {
    return {{"eye", to_json(camera.eye)},
            {"target", to_json(camera.target)},
            {"up", to_json(camera.up)},
            {"vertical_field_of_view", camera.vertical_field_of_view}};
}

Camera camera_in(const Json& json) {
    return {vector_in(json.at("eye")), vector_in(json.at("target")), vector_in(json.at("up")),
            json.at("vertical_field_of_view").get<float>()};
}

Json to_json(const Ray& ray) {
    return {{"origin", to_json(ray.origin)},
            {"direction", to_json(ray.direction)},
            {"t_min", ray.t_min},
            {"t_max", ray.t_max}};
}

Ray ray_in(const Json& json) {
    return {vector_in(json.at("origin")), vector_in(json.at("direction")),
            json.at("t_min").get<float>(), json.at("t_max").get<float>()};
}

template <class Choice>
Choice choice_in(const Json& json, const Words<Choice>& words) {
    const auto text = json.get<std::string>();
    for (const auto& [word, choice] : words) {
        if (word == text) {
            return choice;
        }
    }
    throw InputError("there is no choice `" + text + "`");
}

// Reads the fields that are there, one after the other.
class Fields {
public:
    explicit Fields(const Json& json) : json_(json) {}

    // Calls take(value) where the field is there.
    template <class Take>
    void field(const std::string& name, const Take& take) {
        if (!json_.contains(name)) {
            return;
        }
        try {
            take(json_.at(name));
        } catch (const std::exception& error) {
            throw InputError("`" + name + "` cannot be read: " + error.what());
        }
    }

private:
    const Json& json_;
};

void read_what_to_see(Fields& fields, State& state) {
    fields.field("scene", [&](const Json& j) { state.scene = j.get<std::string>(); });
    fields.field("hard_case", [&](const Json& j) { state.hard_case = j.get<std::string>(); });
    fields.field("hard_ray", [&](const Json& j) { state.hard_ray = j.get<int>(); });
    fields.field("structures",
                 [&](const Json& j) { state.structures = j.get<std::vector<std::string>>(); });
    fields.field("build_values", [&](const Json& j) {
        state.build_values = j.get<std::map<std::string, std::string>>();
    });
    fields.field("camera", [&](const Json& j) { state.camera = camera_in(j); });
    fields.field("picture", [&](const Json& j) { state.picture = pair_in(j); });
    fields.field("pixel", [&](const Json& j) { state.pixel = pair_in(j); });
    fields.field("ray", [&](const Json& j) { state.ray = ray_in(j); });
    fields.field("bounces", [&](const Json& j) { state.bounces = j.get<int>(); });
    fields.field("path_ray", [&](const Json& j) { state.path_ray = j.get<int>(); });
    fields.field("step", [&](const Json& j) { state.step = j.get<int>(); });
}

void read_how_it_is_drawn(Fields& fields, State& state) {
    fields.field("model", [&](const Json& j) { state.model = choice_in(j, model_words()); });
    fields.field("show", [&](const Json& j) { state.filter = choice_in(j, filter_words()); });
    fields.field("color", [&](const Json& j) { state.color = choice_in(j, color_words()); });
    fields.field("levels", [&](const Json& j) {
        const glm::ivec2 levels = pair_in(j);
        state.lowest_level = levels.x;
        state.highest_level = levels.y;
    });
    fields.field("opacity", [&](const Json& j) { state.opacity = j.get<double>(); });
    fields.field("most_cells", [&](const Json& j) { state.most_cells = j.get<int>(); });
    fields.field("clip", [&](const Json& j) {
        state.clip = ClipPlane{vector_in(j.at("point")), vector_in(j.at("normal"))};
    });
    fields.field("heat_map",
                 [&](const Json& j) { state.heat_map = choice_in(j, heat_map_words()); });
    fields.field("table", [&](const Json& j) { state.table = j.get<bool>(); });
    fields.field("sort_by", [&](const Json& j) { state.sort_by = choice_in(j, sort_words()); });
    fields.field("descending", [&](const Json& j) { state.descending = j.get<bool>(); });
    fields.field("first_row", [&](const Json& j) { state.first_row = j.get<int>(); });
    fields.field("selected", [&](const Json& j) { state.selected = j.get<int>(); });
    fields.field("help", [&](const Json& j) { state.help = j.get<bool>(); });
    fields.field("viewpoint", [&](const Json& j) { state.viewpoint = camera_in(j); });
    fields.field("window", [&](const Json& j) { state.window = pair_in(j); });
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

} // namespace

std::string state_text(const State& state) {
    Json json;
    json["scene"] = state.scene;
    json["hard_case"] = state.hard_case;
    json["hard_ray"] = state.hard_ray;
    json["structures"] = state.structures;
    json["build_values"] = state.build_values;
    if (state.camera) {
        json["camera"] = to_json(*state.camera);
    }
    json["picture"] = to_json(state.picture);
    if (state.pixel) {
        json["pixel"] = to_json(*state.pixel);
    }
    if (state.ray) {
        json["ray"] = to_json(*state.ray);
    }
    json["bounces"] = state.bounces;
    json["path_ray"] = state.path_ray;
    json["step"] = state.step;
    json["model"] = word_of(model_words(), state.model);
    json["show"] = word_of(filter_words(), state.filter);
    json["color"] = word_of(color_words(), state.color);
    json["levels"] = {state.lowest_level, state.highest_level};
    json["opacity"] = state.opacity;
    json["most_cells"] = state.most_cells;
    if (state.clip) {
        json["clip"] = {{"point", to_json(state.clip->point)},
                        {"normal", to_json(state.clip->normal)}};
    }
    json["heat_map"] = word_of(heat_map_words(), state.heat_map);
    json["table"] = state.table;
    json["sort_by"] = word_of(sort_words(), state.sort_by);
    json["descending"] = state.descending;
    json["first_row"] = state.first_row;
    json["selected"] = state.selected;
    json["help"] = state.help;
    if (state.viewpoint) {
        json["viewpoint"] = to_json(*state.viewpoint);
    }
    json["window"] = to_json(state.window);
    return json.dump(2) + "\n";
}

State parse_state(const std::string& text, const std::string& name) {
    try {
        const Json json = Json::parse(text);
        if (!json.is_object() || !json.contains("structures")) {
            throw InputError("it has no field `structures`");
        }
        State state;
        Fields fields(json);
        read_what_to_see(fields, state);
        read_how_it_is_drawn(fields, state);
        check(state);
        return state;
    } catch (const std::exception& error) {
        throw InputError(name + ": this is no state of the visualizer, " + error.what() +
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

} // namespace raysteps::view
