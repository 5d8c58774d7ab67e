#include "question.h"

#include "basics/error.h"

#include <nlohmann/json.hpp>

#include <array>
#include <bit>

namespace raysteps {

namespace {

using Json = nlohmann::json;

QuestionKind kind_of(const std::string& name) {
    static const std::map<std::string, QuestionKind> kinds{{"checkpoint", QuestionKind::checkpoint},
                                                           {"walk", QuestionKind::walk},
                                                           {"rays", QuestionKind::rays},
                                                           {"picture", QuestionKind::picture},
                                                           {"difference", QuestionKind::difference},
                                                           {"builder", QuestionKind::builder},
                                                           {"function", QuestionKind::function}};
    const auto place = kinds.find(name);
    if (place == kinds.end()) {
        throw InputError("the kind `" + name +
                         "` is not known. Take checkpoint, walk, rays, picture, difference, "
                         "builder or function.");
    }
    return place->second;
}

Ray ray_of(const Json& json) {
    const auto bits = json.get<std::array<std::uint32_t, 8>>();
    std::array<float, 8> numbers{};
    for (std::size_t i = 0; i < bits.size(); ++i) {
        numbers[i] = std::bit_cast<float>(bits[i]);
    }
    const auto [ox, oy, oz, dx, dy, dz, t_min, t_max] = numbers;
    return {{ox, oy, oz}, {dx, dy, dz}, t_min, t_max};
}

template <class Vector>
std::map<std::string, Vector> vectors_of(const Json& json) {
    std::map<std::string, Vector> vectors;
    for (const auto& [name, value] : json.items()) {
        const auto numbers = value.template get<std::array<typename Vector::value_type, 3>>();
        vectors[name] = Vector(numbers[0], numbers[1], numbers[2]);
    }
    return vectors;
}

CourseQuestion question_of(const Json& json) {
    CourseQuestion question;
    question.kind = kind_of(json.at("kind").get<std::string>());
    question.subject = json.at("subject").get<std::string>();
    question.scene = json.value("scene", question.scene);
    question.triangle = json.value("triangle", question.triangle);
    question.structure = json.value("structure", question.structure);
    question.observer = json.value("observer", question.observer);
    question.options = json.value("options", question.options);
    question.random_rays = json.value("random_rays", question.random_rays);
    question.seed = json.value("seed", question.seed);
    question.families = json.value("families", question.families);
    if (question.families.empty()) {
        throw InputError("the list `families` is empty. Name one, or leave the list out.");
    }
    question.steps = json.value("steps", question.steps);
    question.width = json.value("width", question.width);
    question.height = json.value("height", question.height);
    question.numbers = json.value("numbers", question.numbers);
    question.points = vectors_of<glm::vec3>(json.value("points", Json::object()));
    question.counts = vectors_of<glm::ivec3>(json.value("counts", Json::object()));
    question.zeros = json.value("zeros", question.zeros);
    question.packed = json.value("packed", std::string());
    question.picture = json.value("picture", std::string());
    question.reference = json.value("reference", std::string());
    for (const Json& ray : json.value("rays", Json::array())) {
        question.rays.push_back(ray_of(ray));
    }
    return question;
}

} // namespace

Job parse_job(const std::string& text, const std::string& place) {
    Job job;
    try {
        const Json all = Json::parse(text);
        job.shaders = all.value("shaders", std::string());
        for (const Json& json : all.at("questions")) {
            job.questions.push_back(question_of(json));
        }
    } catch (const Json::exception& error) {
        throw InputError(place + ": is no job of questions (" + error.what() +
                         "). Let ./course write it.");
    }
    return job;
}

} // namespace raysteps
