#include "scene/ray_file.h"

#include "error/error.h"
#include "file/read_file.h"
#include "file/write_file.h"
#include "scene/ray_csv.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace raysteps {

static_assert(std::endian::native == std::endian::little, "ray files are little-endian");

namespace {

// 128 million rays: more than the textures of a machine hold.
constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 30;

bool is_csv(const std::filesystem::path& path) {
    return path.extension() == ".csv";
}

std::vector<Ray> parse_binary(const std::string& bytes, const std::filesystem::path& path) {
    if (bytes.size() % sizeof(Ray) != 0) {
        throw InputError(path.string() + ": the file has " + std::to_string(bytes.size()) +
                         " bytes, but a ray has 32 (8 float32). Check how it was written.");
    }
    std::vector<Ray> rays(bytes.size() / sizeof(Ray));
    if (!bytes.empty()) {
        std::memcpy(rays.data(), bytes.data(), bytes.size());
    }
    return rays;
}

bool is_finite(const glm::vec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void check(const Ray& ray, std::size_t number, const std::filesystem::path& path) {
    const std::string place = path.string() + ": ray " + std::to_string(number) + " (from 0)";
    if (!is_finite(ray.origin) || !is_finite(ray.direction) || !std::isfinite(ray.t_min) ||
        std::isnan(ray.t_max)) {
        throw InputError(place + " has a number that is not finite. Only t_max may be infinite.");
    }
    if (ray.direction == glm::vec3(0.0f)) {
        throw InputError(place + " has no direction. Leave it out, or give it one.");
    }
}

void append_csv(std::string& text, const Hit& hit) {
    char line[96];
    // Nine digits give back the same float.
    std::snprintf(line, sizeof line, "%.9g,%.9g,%.9g,%d\n", static_cast<double>(hit.t),
                  static_cast<double>(hit.u), static_cast<double>(hit.v), hit.triangle);
    text += line;
}

} // namespace

std::vector<Ray> read_ray_file(const std::filesystem::path& path) {
    const std::string bytes = read_file(path, most_bytes);
    std::vector<Ray> rays = is_csv(path) ? parse_ray_csv(bytes, path) : parse_binary(bytes, path);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        check(rays[i], i, path);
    }
    return rays;
}

void write_hit_file(const std::filesystem::path& path, std::span<const Hit> hits) {
    std::string bytes;
    if (is_csv(path)) {
        bytes = "t,u,v,triangle\n";
        for (const Hit& hit : hits) {
            append_csv(bytes, hit);
        }
    } else if (!hits.empty()) {
        bytes.resize(hits.size_bytes());
        std::memcpy(bytes.data(), hits.data(), hits.size_bytes());
    }
    write_file(path, bytes);
}

} // namespace raysteps
