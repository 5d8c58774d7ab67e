#include "compare_generations.h"

#include "basics/statistics.h"
#include "image/heat_map.h"
#include "image/image.h"
#include "program/figures.h"
#include "reference/reference_ray.h"
#include "render/rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iostream>

namespace raysteps {

namespace {

std::vector<float> lengths_of(std::span<const Ray> rays) {
    std::vector<float> lengths;
    for (const Ray& ray : rays) {
        lengths.push_back(glm::length(ray.direction));
    }
    return lengths;
}

} // namespace

void compare_generations(const Scene& scene, const PictureSize& size,
                         const std::filesystem::path& out, const std::filesystem::path& json) {
    const Camera& camera = scene.camera;
    const auto generate = [&](RayGeneration generation) {
        return read_rays(generate_rays(camera, size.width, size.height, generation));
    };
    const std::vector<Ray> interpolated = generate(RayGeneration::interpolated);
    const std::vector<Ray> direct = generate(RayGeneration::direct);
    const auto errors_of = [&](std::span<const Ray> rays) {
        return direction_errors(rays, camera, size.width, size.height);
    };
    const std::vector<float> interpolated_errors = errors_of(interpolated);
    const std::vector<float> direct_errors = errors_of(direct);
    const Summary of_interpolated = summarize(interpolated_errors);
    const Summary of_direct = summarize(direct_errors);
    const std::vector<float> lengths = lengths_of(direct);
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());

    std::cout << "error of the directions, in ulp:\n"
              << "  interpolated  " << to_string(of_interpolated) << "\n"
              << "  direct        " << to_string(of_direct) << "\n"
              << "length of the directions: " << *shortest << " to " << *longest
              << ", so t counts another distance in each pixel\n";

    const auto upper = static_cast<float>(std::max(of_interpolated.largest, of_direct.largest));
    const HeatMapRange range{0.0f, std::max(upper, 0.1f)};
    const auto map = [&](std::span<const float> errors) {
        return heat_map(errors, size.width, size.height, range, "error of the direction [ulp]");
    };
    const std::vector<Image> maps{map(interpolated_errors), map(direct_errors)};
    const std::vector<std::string> captions{"interpolated by the rasterizer",
                                            "computed by each pixel"};
    write_picture(out / "errors.png", side_by_side(maps, captions));

    const auto numbers = [](const Summary& summary) {
        return Numbers{{"median_ulp", summary.median},
                       {"percentile_99_ulp", summary.percentile_99},
                       {"largest_ulp", summary.largest}};
    };
    write_figures(json, {.schema = "generations.schema.json", .scenes = {record_of(scene)}},
                  {{"interpolated", numbers(of_interpolated)},
                   {"direct", numbers(of_direct)},
                   {"shortest_direction", *shortest},
                   {"longest_direction", *longest}});
}

} // namespace raysteps
