#include "answer.h"

#include "basics/file.h"

#include <nlohmann/json.hpp>

#include <bit>

namespace raysteps {

namespace {

nlohmann::json json_of(const Ray& ray) {
    const std::array<float, 8> numbers{ray.origin.x,    ray.origin.y,    ray.origin.z,
                                       ray.direction.x, ray.direction.y, ray.direction.z,
                                       ray.t_min,       ray.t_max};
    nlohmann::json json = nlohmann::json::array();
    for (const float number : numbers) {
        json.push_back(std::bit_cast<std::uint32_t>(number));
    }
    return json;
}

} // namespace

void write_answers(const std::filesystem::path& file, std::span<const Answer> answers) {
    nlohmann::json all = nlohmann::json::array();
    for (const Answer& answer : answers) {
        nlohmann::json rays = nlohmann::json::array();
        for (const Ray& ray : answer.rays) {
            rays.push_back(json_of(ray));
        }
        all.push_back({{"rays", rays}, {"steps", answer.steps}});
    }
    write_file(file, nlohmann::json{{"answers", all}}.dump());
}

} // namespace raysteps
