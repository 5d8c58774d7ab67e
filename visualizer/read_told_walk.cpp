#include "read_told_walk.h"

#include "basics/error.h"
#include "basics/file.h"
#include "walk_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace raysteps::view {

namespace {

using Json = nlohmann::json;

constexpr std::uintmax_t most_bytes = 1U << 28U;

// JSON has neither NaN nor infinity.
float number_of(const Json& json) {
    if (!json.is_string()) {
        return json.get<float>();
    }
    const std::string word = json.get<std::string>();
    if (word == "nan") {
        return std::numeric_limits<float>::quiet_NaN();
    }
    if (word != "infinity" && word != "-infinity") {
        throw InputError("`" + word + "` is no number");
    }
    const float infinity = std::numeric_limits<float>::infinity();
    return word == "infinity" ? infinity : -infinity;
}

glm::vec3 point_of(const Json& json) {
    return {number_of(json.at(0)), number_of(json.at(1)), number_of(json.at(2))};
}

Hit hit_of(const Json& json, const Ray& ray) {
    if (json.is_null()) {
        return {ray.t_max, 0.0f, 0.0f, no_triangle};
    }
    return {number_of(json.at("t")), number_of(json.at("u")), number_of(json.at("v")),
            json.at("triangle").get<int>()};
}

template <class Choice, std::size_t count>
Choice choice_of(const Json& json, const std::array<const char*, count>& words) {
    const auto word = std::find(words.begin(), words.end(), json.get<std::string>());
    if (word == words.end()) {
        throw InputError("there is no choice " + json.dump());
    }
    return static_cast<Choice>(word - words.begin());
}

ToldStep step_of(const Json& json, const Ray& ray) {
    ToldStep step;
    step.place = json.at("place").get<int>();
    step.round = json.value("round", 0);
    json.at("tested").get_to(step.tested);
    step.nearest = hit_of(json.at("nearest"), ray);
    if (json.contains("outcome")) {
        step.outcome = choice_of<Outcome>(json.at("outcome"), outcome_words);
    }
    if (json.contains("box") && !json.at("box").is_null()) {
        step.box = Box{point_of(json.at("box").at(0)), point_of(json.at("box").at(1))};
    }
    return step;
}

ToldWalk walk_of(const Json& json) {
    if (json.at("schema") != walk_schema || json.at("schema_version") != walk_schema_version) {
        throw InputError("its schema is another");
    }
    ToldWalk walk;
    walk.name = json.at("name").get<std::string>();
    walk.scene = json.value("scene", std::string());
    walk.structure = json.at("structure").get<std::string>();
    const Json& ray = json.at("ray");
    walk.ray = {point_of(ray.at("origin")), point_of(ray.at("direction")),
                number_of(ray.at("t_min")), number_of(ray.at("t_max"))};
    walk.question = choice_of<Question>(json.at("question"), question_words);
    for (const Json& step : json.at("steps")) {
        walk.steps.push_back(step_of(step, walk.ray));
    }
    walk.ended = json.at("ended").get<bool>();
    walk.hit = hit_of(json.at("hit"), walk.ray);
    return walk;
}

} // namespace

ToldWalk read_told_walk(const std::filesystem::path& path) {
    const std::string text = read_file(path, most_bytes);
    try {
        return walk_of(Json::parse(text));
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": is no file of recorded steps (" + error.what() +
                         "). Write it as visualizer/" + walk_schema + " says.");
    }
}

} // namespace raysteps::view
