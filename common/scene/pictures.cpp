#include "scene/pictures.h"

#include "basics/error.h"

#include <algorithm>
#include <map>
#include <utility>

namespace raysteps {

namespace {

// Textures made by code have no holes (render/effects/textures.cpp).
constexpr const char* made_by_code = "made:";

std::string bytes_of(const Scene& scene, const std::string& name) {
    const auto enclosed =
        std::find_if(scene.enclosed.begin(), scene.enclosed.end(),
                     [&](const EnclosedPicture& picture) { return picture.name == name; });
    return enclosed == scene.enclosed.end() ? read_picture_bytes(name) : enclosed->bytes;
}

enum class Holes { none, some, unknown };

class HoleFinder {
public:
    explicit HoleFinder(const Scene& scene) : scene_(scene) {}

    Holes by_any(const std::string& name, float cutoff) {
        const Opacity* opacity = read(name);
        return opacity == nullptr ? Holes::unknown : in(*opacity, cutoff);
    }

    Holes by_alpha(const std::string& name, float cutoff) {
        const Opacity* opacity = read(name);
        const bool has_alpha = opacity != nullptr && opacity->is_alpha;
        return has_alpha ? in(*opacity, cutoff) : Holes::none;
    }

    const std::string& problem(const std::string& name) { return problems_[name]; }

private:
    static Holes in(const Opacity& opacity, float cutoff) {
        const bool has_hole =
            std::any_of(opacity.values.begin(), opacity.values.end(), [&](std::uint8_t value) {
                return static_cast<float>(value) < 255.0f * cutoff;
            });
        return has_hole ? Holes::some : Holes::none;
    }

    const Opacity* read(const std::string& name) {
        const auto [entry, is_new] = opacities_.try_emplace(name);
        if (is_new) {
            try {
                entry->second = opacity_of(scene_, name);
            } catch (const InputError& error) {
                problems_[name] = error.what();
            }
        }
        return problems_.contains(name) && !problems_[name].empty() ? nullptr : &entry->second;
    }

    const Scene& scene_;
    std::map<std::string, Opacity> opacities_;
    std::map<std::string, std::string> problems_;
};

} // namespace

Image picture_of(const Scene& scene, const std::string& name) {
    return decode_picture(bytes_of(scene, name), name);
}

Opacity opacity_of(const Scene& scene, const std::string& name) {
    return decode_opacity(bytes_of(scene, name), name);
}

Scene find_cutouts(Scene scene) {
    HoleFinder finder(scene);
    std::vector<Material> materials = scene.materials;
    std::vector<std::string> messages;
    for (Material& material : materials) {
        const bool has_map = !material.cutout_map.empty();
        const std::string& texture = material.diffuse_map;
        if (has_map) {
            const Holes holes = finder.by_any(material.cutout_map, material.cutoff);
            if (holes == Holes::unknown) {
                messages.push_back("Material " + material.name + ": it has no holes. " +
                                   finder.problem(material.cutout_map));
            }
            material.cutout_map = holes == Holes::some ? material.cutout_map : "";
        } else if (!texture.empty() && !texture.starts_with(made_by_code) &&
                   finder.by_alpha(texture, material.cutoff) == Holes::some) {
            material.cutout_map = texture;
        }
    }
    scene.materials = std::move(materials);
    scene.messages.insert(scene.messages.end(), messages.begin(), messages.end());
    return scene;
}

} // namespace raysteps
