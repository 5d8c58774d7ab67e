#include "scene/scene.h"

#include <fmt/core.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace raysteps {

namespace {

// G. Fowler, L. C. Noll and K.-P. Vo, "FNV hash history"; 64 bits, variant 1a.
class SceneHash {
public:
    void add(std::uint8_t byte) { state_ = (state_ ^ byte) * 0x100000001b3U; }

    void add(std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) {
            add(static_cast<std::uint8_t>(word >> shift));
        }
    }
    void add(int number) { add(static_cast<std::uint32_t>(number)); }
    void add(float number) { add(std::bit_cast<std::uint32_t>(number)); }

    void add(const glm::vec2& vector) {
        add(vector.x);
        add(vector.y);
    }
    void add(const glm::vec3& vector) {
        add(vector.x);
        add(vector.y);
        add(vector.z);
    }
    void add(std::string_view text) {
        add(static_cast<std::uint32_t>(text.size()));
        for (const char letter : text) {
            add(static_cast<std::uint8_t>(letter));
        }
    }
    void add(const Material& material) {
        add(material.diffuse);
        add(material.specular);
        add(material.shininess);
        add(material.emission);
        add(material.refractive_index);
        add(material.opacity);
        add(material.transmission);
        add(material.illumination_model);
        add(std::filesystem::path(material.diffuse_map).filename().string());
        if (!material.cutout_map.empty()) { // so that scenes without one keep their digits
            add(std::filesystem::path(material.cutout_map).filename().string());
            add(material.cutoff);
        }
        if (!material.normal_map.empty()) {
            add("normal_map");
            add(std::filesystem::path(material.normal_map).filename().string());
        }
        if (!material.emissive_map.empty()) {
            add("emissive_map");
            add(std::filesystem::path(material.emissive_map).filename().string());
            add(material.emissive_factor);
        }
    }
    void add(const Light& light) {
        add(light.position);
        add(light.color);
        add(light.across);
        add(light.along);
    }

    // The number first: so a value cannot pass from one list to the next.
    template <class Value>
    void add(const std::vector<Value>& values) {
        add(static_cast<std::uint32_t>(values.size()));
        for (const Value& value : values) {
            add(value);
        }
    }

    std::string digits() const { return fmt::format("{:016x}", state_); }

private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

} // namespace

std::string hash_of(const Scene& scene) {
    SceneHash hash;
    hash.add(scene.corners);
    hash.add(scene.normals);
    if (scene.texture_coordinates.empty()) { // counts as if all were zero
        hash.add(static_cast<std::uint32_t>(scene.corners.size()));
        for (std::size_t i = 0; i < scene.corners.size(); ++i) {
            hash.add(glm::vec2(0.0f));
        }
    } else {
        hash.add(scene.texture_coordinates);
    }
    hash.add(scene.triangle_materials);
    hash.add(scene.materials);
    hash.add(scene.lights);
    if (!scene.corner_colors.empty()) {
        hash.add(scene.corner_colors);
    }
    const Sky sky = scene.sky.value_or(Sky{scene.background, scene.background, scene.background});
    hash.add(sky.zenith);
    hash.add(sky.horizon);
    hash.add(sky.ground);
    return hash.digits();
}

} // namespace raysteps
