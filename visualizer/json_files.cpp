#include "json_files.h"

#include "basics/error.h"
#include "basics/file.h"
#include "state_fields.h"

#include <nlohmann/json.hpp>

#include <algorithm>
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

} // namespace raysteps::view
