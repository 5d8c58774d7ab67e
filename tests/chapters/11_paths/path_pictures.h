#pragma once

#include "11_paths/path_renderer.h"
#include "11_paths/path_sums.h"
#include "gpu/context.h"
#include "reference/reference_paths.h"
#include "scene/load_scene.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/structure.h"

#include <cmath>
#include <string>
#include <vector>

namespace raysteps {

inline PathRenderer path_renderer(const Scene& scene, const PathChoice& choice) {
    const BuiltStructure structure = family_of("bvh_ordered").build(scene.corners, {});
    return {
        scene,
        upload(scene, structure),
        choice,
        {{"triangle", "triangle/watertight.glsl"}, {"structure", "structure/bvh/bvh_ordered.glsl"}},
        measure_limits()};
}

// So many blocks of 16 samples. A context must be current.
inline PathSums follow_paths(const Scene& scene, const PathChoice& choice, int side, int blocks) {
    PathRenderer renderer = path_renderer(scene, choice);
    PathSums sums({.scene = scene.name, .width = side, .height = side});
    sums.sees_lamp = renderer.pixels_with_lamps(scene.camera, side, side);
    for (int block = 0; block < blocks; ++block) {
        add_block(sums, block, renderer.render_block(scene.camera, side, side, block));
    }
    return sums;
}

// The mean of a picture without its lamps, and the standard error of that mean. The error is that
// of the channels one by one, so never too small for their mean.
struct MeasuredMean {
    double mean = 0.0;
    double error = 0.0;
};

inline MeasuredMean measured_mean(const PathSums& sums) {
    const Image image = mean_of(sums);
    const std::vector<float> variances = variance_of_mean(sums);
    MeasuredMean measured;
    double variance = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (sums.sees_lamp[i] == 0) {
            const glm::dvec3 pixel(image.pixels[i]);
            measured.mean += (pixel.x + pixel.y + pixel.z) / 3.0;
            variance += static_cast<double>(variances[i]);
            count += 1.0;
        }
    }
    measured.mean /= count;
    measured.error = std::sqrt(variance) / count;
    return measured;
}

inline MeasuredMean measured_mean(const std::vector<ReferencePixel>& pixels,
                                  const std::vector<std::uint8_t>& left_out) {
    MeasuredMean measured;
    double variance = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (left_out[i] == 0) {
            const ReferencePixel& pixel = pixels[i];
            measured.mean += (pixel.mean.x + pixel.mean.y + pixel.mean.z) / 3.0;
            variance += (pixel.variance.x + pixel.variance.y + pixel.variance.z) / 3.0;
            count += 1.0;
        }
    }
    measured.mean /= count;
    measured.error = std::sqrt(variance) / count;
    return measured;
}

// A difference of both means is beyond this many standard errors in 1 of 10^6 runs where there is
// no bias (both sides of the normal distribution).
inline constexpr double alarm_at = 4.892;

// A bias of `alarm_at + power_at` standard errors is found in 99.9 % of runs.
inline constexpr double power_at = 3.091;

// How many standard errors lie between both.
inline double apart(const MeasuredMean& a, const MeasuredMean& b) {
    return std::abs(a.mean - b.mean) / std::hypot(a.error, b.error);
}

// The smallest bias that is found in 99.9 % of runs, as a part of the mean.
inline double smallest_bias_found(const MeasuredMean& a, const MeasuredMean& b) {
    return (alarm_at + power_at) * std::hypot(a.error, b.error) / b.mean;
}

inline Material glowing_material(const glm::vec3& diffuse, const glm::vec3& emission) {
    Material material;
    material.diffuse = diffuse;
    material.emission = emission;
    return material;
}

} // namespace raysteps
