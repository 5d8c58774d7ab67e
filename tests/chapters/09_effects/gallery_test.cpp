#include "basics/error.h"
#include "catch.h"
#include "effect_pictures.h"
#include "image/color.h"
#include "scene/load_model.h"
#include "support/scratch_folder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

using namespace raysteps;

namespace {

// The gallery's models that are made by code.
class GalleryModels {
public:
    explicit GalleryModels(const std::string& test_name) : folder_(test_name) {
        const std::string command = "python3 -B " RAYSTEPS_SOURCE_DIR "/scripts/gallery --out " +
                                    (folder_ / "").string() + " > /dev/null";
        REQUIRE(std::system(command.c_str()) == 0);
    }

    // Those that can be read: without Assimp, others than OBJ and PLY cannot.
    std::vector<std::string> files() const {
        std::vector<std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder_ / "")) {
            if (is_model_path(entry.path()) && can_be_read(entry.path())) {
                files.push_back(entry.path().string());
            }
        }
        std::sort(files.begin(), files.end());
        return files;
    }

private:
    static bool can_be_read(const std::filesystem::path& file) {
        try {
            return triangle_count(load_model(file, Origin::near_model)) > 0;
        } catch (const InputError& error) {
            REQUIRE_THAT(error.what(), contains_text("libassimp-dev"));
            WARN("skipped: built without libassimp-dev");
            return false;
        }
    }

    ScratchFolder folder_;
};

std::vector<std::string> effects_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const EffectCall& call : make_plan(scene, 1.0, "", {}).called) {
        names.emplace_back(row_of(call.effect).name);
    }
    return names;
}

struct Brightness {
    float median = 0.0f;  // of sRGB, from 0 to 1
    double clipped = 0.0; // the share of pixels
};

Brightness brightness_of(const Image& image) {
    Brightness brightness;
    std::vector<float> seen;
    for (const glm::vec3& pixel : image.pixels) {
        const float luminance = 0.2126f * pixel.x + 0.7152f * pixel.y + 0.0722f * pixel.z;
        seen.push_back(srgb_from_linear(std::clamp(luminance, 0.0f, 1.0f)));
        brightness.clipped += std::max({pixel.x, pixel.y, pixel.z}) > 1.0f ? 1.0 : 0.0;
    }
    std::nth_element(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2),
                     seen.end());
    brightness.median = seen[seen.size() / 2];
    brightness.clipped /= static_cast<double>(seen.size());
    return brightness;
}

} // namespace

TEST_CASE("a model calls for the effects that its file asks for", "[09][gallery]") {
    const GalleryModels models("gallery_effects");
    using Names = std::vector<std::string>;
    const std::map<std::string, Names> expected{
        {"domes.glb", {"diffuse", "shadows", "normal_maps"}},
        {"hedge.glb", {"textures", "diffuse", "shadows", "cutouts"}},
        {"hills.ply", {"diffuse", "shadows", "vertex_colors"}},
        {"room.obj", {"diffuse", "shadows", "soft_shadows"}},
        {"sign.glb", {"diffuse", "shadows", "emissive_maps"}}};
    const std::vector<std::string> files = models.files();
    CHECK(files.size() >= 2);
    for (const std::string& file : files) {
        CAPTURE(file);
        CHECK(effects_of(load_scene(file, 1.0f)) ==
              expected.at(std::filesystem::path(file).filename().string()));
    }
}

TEST_CASE("pictures of the gallery's models are neither dark nor clipped", "[09][gallery]") {
    const GalleryModels models("gallery_brightness");
    const auto context = make_context(ContextKind::automatic);
    std::vector<std::string> files = models.files();
    const bool has_importer = files.size() > 2;
    for (const std::string name : {"bunny.obj", "horse.3ds", "cat.3ds", "asteroid-high.3ds"}) {
        const std::filesystem::path file = "/usr/share/glmark2/models/" + name;
        if (std::filesystem::exists(file) && (has_importer || file.extension() == ".obj")) {
            files.push_back(file.string());
        }
    }
    for (const std::string& file : files) {
        CAPTURE(file);
        const UpAxis up = file.ends_with("hills.ply") ? UpAxis::z : UpAxis::y;
        const Scene scene = load_scene(file, 1.0f, {.camera = {.up = up}});
        const Brightness brightness = brightness_of(effect_picture(scene, 64).image);
        CHECK(brightness.median >= 0.15f);
        CHECK(brightness.median <= 0.7f);
        CHECK(brightness.clipped < 0.03);
    }
}
