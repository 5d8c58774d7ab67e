#include "render/effects/effect_buffers.h"

#include "basics/error.h"
#include "basics/text.h"
#include "image/color.h"
#include "scene/pictures.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace raysteps {

namespace {

constexpr int side = 512;
constexpr float turn = 2.0f * std::numbers::pi_v<float>;

// Colours at (u, v) from 0 to 1, from the lower left on.
template <class ColorAt>
Image painted(int width, int height, const ColorAt& color_at) {
    Image image(width, height);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const float u = (static_cast<float>(column) + 0.5f) / static_cast<float>(width);
            const float v = 1.0f - (static_cast<float>(row) + 0.5f) / static_cast<float>(height);
            image.at(column, row) = glm::clamp(color_at(u, v), 0.0f, 1.0f);
        }
    }
    return image;
}

// A gentle field of values around 0, which repeats with u and v.
float ripple(float u, float v, int waves) {
    const auto f = static_cast<float>(waves);
    return 0.5f * std::sin(turn * f * u + 3.0f * std::sin(turn * v)) +
           0.3f * std::sin(turn * (2.0f * f + 1.0f) * v + 2.0f * std::sin(turn * f * u)) +
           0.2f * std::sin(turn * (3.0f * f * u + 2.0f * f * v));
}

Image checker() {
    return painted(side, side, [](float u, float v) {
        const int sum = static_cast<int>(u * 8.0f) + static_cast<int>(v * 8.0f);
        return sum % 2 == 0 ? glm::vec3(0.72f, 0.70f, 0.65f) : glm::vec3(0.10f, 0.12f, 0.16f);
    });
}

Image bricks() {
    return painted(side, side, [](float u, float v) {
        const float rows = v * 8.0f;
        const auto row = static_cast<int>(rows);
        const float columns = u * 4.0f + (row % 2 == 0 ? 0.0f : 0.5f);
        const auto column = static_cast<int>(columns) % 4;
        const float x = columns - std::floor(columns);
        const float y = rows - std::floor(rows);
        const bool mortar = x < 0.04f || x > 0.96f || y < 0.08f || y > 0.92f;
        const float grain = 0.06f * ripple(u, v, 9);
        const float tone = 0.12f * static_cast<float>((row * 7 + column * 5) % 4) / 3.0f;
        return mortar ? glm::vec3(0.55f + grain, 0.53f + grain, 0.49f + grain)
                      : glm::vec3(0.46f + tone + grain, 0.16f + 0.5f * tone + grain, 0.10f + grain);
    });
}

Image wood() {
    return painted(side, side, [](float u, float v) {
        const float plank = u * 6.0f;
        const float x = plank - std::floor(plank);
        const float shift = std::fmod(std::floor(plank) * 0.618f, 1.0f);
        const float grain =
            0.5f + 0.5f * std::sin(turn * (9.0f * x + 0.8f * std::sin(turn * (v + shift))));
        const float seam = x < 0.015f || x > 0.985f ? 0.35f : 1.0f;
        const float tone = 0.75f + 0.35f * shift;
        return seam * tone *
               glm::mix(glm::vec3(0.30f, 0.15f, 0.07f), glm::vec3(0.50f, 0.29f, 0.14f), grain);
    });
}

Image globe() {
    return painted(2 * side, side, [](float u, float v) {
        const float height = ripple(u, v, 2) + 0.35f * ripple(u, v, 5) - 0.15f;
        const float pole = std::abs(v - 0.5f) * 2.0f;
        if (pole + 0.05f * ripple(u, v, 6) > 0.86f) {
            return glm::vec3(0.85f, 0.88f, 0.92f);
        }
        if (height < 0.0f) {
            return glm::mix(glm::vec3(0.05f, 0.20f, 0.42f), glm::vec3(0.02f, 0.07f, 0.22f),
                            std::min(1.0f, -2.0f * height));
        }
        return glm::mix(glm::vec3(0.13f, 0.34f, 0.10f), glm::vec3(0.48f, 0.38f, 0.22f),
                        std::min(1.0f, 1.6f * height));
    });
}

const std::string prefix = "made:";

// The finer texels from first up to end that the texel covers along one axis; an odd last one
// belongs to its neighbour's texel, too.
struct Range {
    int first;
    int end;
};

Range covered(int texel, int finer_size, int size) {
    return {static_cast<int>(static_cast<long>(texel) * finer_size / size),
            static_cast<int>((static_cast<long>(texel + 1) * finer_size + size - 1) / size)};
}

Image halved(const Image& finer) {
    Image image(std::max(1, finer.width / 2), std::max(1, finer.height / 2));
    for (int row = 0; row < image.height; ++row) {
        const Range rows = covered(row, finer.height, image.height);
        for (int column = 0; column < image.width; ++column) {
            const Range columns = covered(column, finer.width, image.width);
            glm::dvec3 sum(0.0);
            for (int y = rows.first; y < rows.end; ++y) {
                for (int x = columns.first; x < columns.end; ++x) {
                    sum += glm::dvec3(finer.at(x, y));
                }
            }
            const int count = (rows.end - rows.first) * (columns.end - columns.first);
            image.at(column, row) = glm::vec3(sum / static_cast<double>(count));
        }
    }
    return image;
}

constexpr int no_texture = -1;

Image load_texture(const Scene& scene, const std::string& name) {
    return is_made_texture(name) ? made_texture(name) : picture_of(scene, name);
}

} // namespace

bool is_made_texture(const std::string& name) {
    return name.starts_with(prefix);
}

Image made_texture(const std::string& name) {
    if (name == "made:checker") {
        return checker();
    }
    if (name == "made:bricks") {
        return bricks();
    }
    if (name == "made:wood") {
        return wood();
    }
    if (name == "made:globe") {
        return globe();
    }
    throw InputError(no_such_choice("map_Kd", name, "texture made by code",
                                    {"made:checker", "made:bricks", "made:wood", "made:globe"}));
}

std::vector<Image> mipmap_of(const Image& image) {
    std::vector<Image> levels{image};
    while (levels.back().width > 1 || levels.back().height > 1) {
        levels.push_back(halved(levels.back()));
    }
    return levels;
}

namespace {

enum class Meaning { color, values };

// Parts of a normal are no brightness: they are meant as they are stored.
Image as_stored(Image image) {
    for (glm::vec3& pixel : image.pixels) {
        pixel = {srgb_from_linear(pixel.x), srgb_from_linear(pixel.y), srgb_from_linear(pixel.z)};
    }
    return image;
}

class TextureLoader {
public:
    explicit TextureLoader(const Scene& scene) : scene_(scene) {}

    // The number of each material's image.
    std::vector<int> load(std::string Material::*map, const std::string& what, Meaning meaning) {
        std::map<std::string, int> number_of_name;
        std::vector<int> numbers;
        for (const Material& material : scene_.materials) {
            if ((material.*map).empty()) {
                numbers.push_back(no_texture);
                continue;
            }
            const auto [entry, is_new] = number_of_name.try_emplace(material.*map, no_texture);
            if (is_new) {
                entry->second = read(material, material.*map, what, meaning);
            }
            numbers.push_back(entry->second);
        }
        return numbers;
    }

    LoadedTextures loaded;

private:
    int read(const Material& material, const std::string& name, const std::string& what,
             Meaning meaning) {
        try {
            Image image = load_texture(scene_, name);
            loaded.images.push_back(meaning == Meaning::values ? as_stored(std::move(image))
                                                               : std::move(image));
            return static_cast<int>(loaded.images.size()) - 1;
        } catch (const InputError& error) {
            loaded.messages.push_back("Material " + material.name + ": its " + what +
                                      " is left out. " + error.what());
            return no_texture;
        }
    }

    const Scene& scene_;
};

} // namespace

LoadedTextures load_textures(const Scene& scene, const EffectSet& effects) {
    TextureLoader loader(scene);
    if (effects.contains(Effect::textures)) {
        loader.loaded.textures = loader.load(&Material::diffuse_map, "texture", Meaning::color);
    }
    if (effects.contains(Effect::normal_maps)) {
        loader.loaded.normals = loader.load(&Material::normal_map, "normal map", Meaning::values);
    }
    if (effects.contains(Effect::emissive_maps)) {
        loader.loaded.glows =
            loader.load(&Material::emissive_map, "emissive picture", Meaning::color);
    }
    return std::move(loader.loaded);
}

} // namespace raysteps
