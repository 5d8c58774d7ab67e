#include "conformance.h"

#include "basics/file.h"
#include "basics/numbers.h"
#include "basics/threads.h"
#include "program/output.h"
#include "scene/ray_file.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <tuple>

namespace raysteps {

namespace {

constexpr std::size_t rays_per_part = 256;

// Each point once, in the order in which triangles name them; nine digits give back the same float.
std::string to_indexed_obj(const Mesh& mesh) {
    std::map<std::tuple<float, float, float>, std::size_t> numbers;
    std::string points;
    std::string faces;
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
        const glm::vec3& corner = mesh.corners[i];
        const auto [place, is_new] =
            numbers.try_emplace({corner.x, corner.y, corner.z}, numbers.size() + 1);
        if (is_new) {
            points += fmt::format("v {:.9g} {:.9g} {:.9g}\n", corner.x, corner.y, corner.z);
        }
        faces +=
            fmt::format("{}{}{}", i % 3 == 0 ? "f " : " ", place->second, i % 3 == 2 ? "\n" : "");
    }
    return points + faces;
}

template <class Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string to_bytes(const std::vector<AllowedAnswer>& answers) {
    std::string bytes;
    for (const AllowedAnswer& answer : answers) {
        append(bytes,
               static_cast<std::uint16_t>((answer.miss ? 1 : 0) | (answer.anything ? 2 : 0)));
        append(bytes, static_cast<std::uint16_t>(answer.hits.size()));
        for (const AllowedHit& hit : answer.hits) {
            append(bytes, hit);
        }
    }
    return bytes;
}

// Half-lines of a usual length, so that each family is about one thing.
void keep_usual_rays(std::vector<Ray>& rays) {
    std::erase_if(rays, [](const Ray& ray) {
        const glm::vec3 sizes = glm::abs(ray.direction);
        const float longest = std::max({sizes.x, sizes.y, sizes.z});
        return longest < 0x1p-60f || longest > 0x1p59f;
    });
    for (Ray& ray : rays) {
        ray.t_min = std::max(ray.t_min, 0.0f);
    }
}

std::vector<AllowedAnswer> answers_of(const HardScene& made, AnswerRules::Origin origin,
                                      const std::string& name) {
    const AnswerRules rules(made.mesh.corners);
    const auto progress = show_progress(name);
    std::vector<AllowedAnswer> answers(made.rays.size());
    in_parts(all_cores, made.rays.size(), rays_per_part, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            answers[i] = rules.allowed(made.rays[i], origin);
        }
        if (begin % (64 * rays_per_part) == 0) {
            progress(static_cast<double>(begin) / static_cast<double>(made.rays.size()));
        }
    });
    progress(1.0);
    return answers;
}

} // namespace

void write_conformance_suite(const std::filesystem::path& folder, const HardRequest& request) {
    Numbers families = empty_list();
    for (const ConformanceFamily& family : conformance_families()) {
        HardScene made = family.make(request);
        if (!family.any_rays) {
            keep_usual_rays(made.rays);
        }
        write_file(folder / (family.name + ".obj"), to_indexed_obj(made.mesh));
        write_ray_file(folder / (family.name + ".f32"), made.rays);
        write_file(folder / (family.name + ".answers"),
                   to_bytes(answers_of(made, family.origin, family.name)));
        families.push_back({{"name", family.name},
                            {"tests", family.tests},
                            {"fails", family.fails},
                            {"inside", family.origin == AnswerRules::Origin::inside},
                            {"seed", request.seed},
                            {"triangles", made.mesh.corners.size() / 3},
                            {"rays", made.rays.size()}});
    }
    const Numbers suite{
        {"suite", "Raysteps conformance suite"}, {"version", 1}, {"families", families}};
    write_file(folder / "suite.json", suite.to_json() + "\n");
}

} // namespace raysteps
