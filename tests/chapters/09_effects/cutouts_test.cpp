#include "catch.h"
#include "effect_pictures.h"
#include "image/image_file.h"
#include "scene/pictures.h"
#include "structure/padding.h"
#include "support/same_bits.h"
#include "support/scratch_folder.h"

#include <glm/geometric.hpp>

#include <algorithm>

using namespace raysteps;

namespace {

// A leaf of 8 x 8 texels: solid where its column plus its row from below is even.
class LeafPicture {
public:
    LeafPicture() {
        Image image(8, 8);
        for (int row = 0; row < 8; ++row) {
            for (int column = 0; column < 8; ++column) {
                const bool solid = (column + 7 - row) % 2 == 0;
                image.at(column, row) = glm::vec3(solid ? 1.0f : 0.0f);
            }
        }
        write_png(folder_ / "leaf.png", image);
    }

    std::string path() const { return (folder_ / "leaf.png").string(); }

private:
    ScratchFolder folder_{"leaf_picture"};
};

Material leaf_material(const LeafPicture& picture) {
    Material material;
    material.name = "leaf";
    material.cutout_map = picture.path();
    return material;
}

// A leaf from (-1, -1) to (1, 1) at z = 0 before a wall at z = -1, which is triangles 2 and 3.
Scene leaf_scene(const LeafPicture& picture) {
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 1.0f), leaf_material(picture));
    scene.texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    scene = add_mesh(std::move(scene), facing_wall(-1.0f, 3.0f), Material{});
    scene.lights = {{{0.0f, 0.0f, 9.0f}, glm::vec3(1.0f)}};
    return scene;
}

// Straight through the middles of the texels, column by column.
std::vector<Ray> rays_through_texels() {
    std::vector<Ray> rays;
    for (int column = 0; column < 8; ++column) {
        for (int row = 0; row < 8; ++row) {
            const glm::vec3 from((static_cast<float>(column) - 3.5f) / 4.0f,
                                 (static_cast<float>(row) - 3.5f) / 4.0f, 5.0f);
            rays.push_back({from, {0, 0, -1}, 0.0f, 100.0f});
        }
    }
    return rays;
}

bool is_solid_texel(std::size_t ray) {
    return (ray / 8 + ray % 8) % 2 == 0;
}

std::vector<Hit> traced(const Scene& scene, const std::string& structure, const Parts& more = {},
                        int rounds = 2048) {
    const std::vector<Ray> rays = rays_through_texels();
    const BuiltStructure built =
        family_of(structure).build(scene.corners, {reach_of(rays, scene.corners), {}});
    Parts parts = walk_parts("watertight", structure);
    parts.insert(more.begin(), more.end());
    TraceRays trace(parts, rounds, Packets::always);
    RayTextures textures = upload_rays(rays);
    textures.coherence = Coherence::neighbours;
    return read_hits(trace.closest_hits(textures, upload(scene, built)), rays.size());
}

void check_holes(const std::vector<Hit>& hits) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        CAPTURE(i);
        CHECK(hits[i].t == (is_solid_texel(i) ? 5.0f : 6.0f));
        CHECK((hits[i].triangle < 2) == is_solid_texel(i));
    }
}

} // namespace

TEST_CASE("every walk goes through the holes of a surface and no other place", "[09][cutouts]") {
    const auto context = make_context(ContextKind::automatic);
    const LeafPicture picture;
    const Scene scene = leaf_scene(picture);
    for (const std::string& structure : structure_names()) {
        CAPTURE(structure);
        check_holes(traced(scene, structure));
    }
}

TEST_CASE("holes are the same to observers, in double precision and over many launches",
          "[09][cutouts]") {
    const auto context = make_context(ContextKind::automatic);
    const LeafPicture picture;
    const Scene scene = leaf_scene(picture);
    check_holes(traced(scene, "bvh4", {{"observer", "observer/count.glsl"}}));
    check_holes(traced(scene, "bvh_stack", {{"real", "exhibit/double_precision.glsl"}}));
    check_holes(traced(scene, "bvh_ordered", {}, 1));
}

TEST_CASE("a walk asks for holes only where a scene has some", "[09][cutouts]") {
    for (const NamedPart& part : list_parts("structure")) {
        CAPTURE(part.name);
        Parts parts{{"real", "real/float.glsl"},
                    {"triangle", "triangle/watertight.glsl"},
                    {"structure", part.file},
                    {"cutout", "cutout/none.glsl"}};
        const std::string plain = read_shader("pass/trace/trace.frag", parts).text;
        CHECK(plain.find("&& is_solid(hit)") !=
              std::string::npos); // a walk without it sees no hole
        CHECK(plain.find("cutout_words") == std::string::npos);
        parts["cutout"] = "cutout/pictures.glsl";
        CHECK(read_shader("pass/trace/trace.frag", parts).text.find("cutout_words") !=
              std::string::npos);
    }
    const auto context = make_context(ContextKind::automatic);
    CHECK(upload(add_mesh(white_scene(), facing_wall(0.0f, 1.0f), Material{})).cutouts.empty());
    const LeafPicture picture;
    CHECK(upload(leaf_scene(picture)).cutouts.size() == 5);
}

TEST_CASE("cut-outs are an effect that materials call for and light shines through them",
          "[09][cutouts][plan]") {
    const auto context = make_context(ContextKind::automatic);
    const LeafPicture picture;
    Scene scene = leaf_scene(picture);
    const Plan plan = make_plan(scene, 1.0, "", {});
    CHECK(has(plan, Effect::cutouts));
    CHECK_THAT(explain(plan), contains_text("material leaf, 2 triangles"));
    // The camera is at the light, so that each lit point of the wall is seen through a hole.
    scene.camera.eye = {0.0f, 0.0f, 9.0f};
    scene.camera.vertical_field_of_view = 10.0f;
    const EffectPicture with = effect_picture(scene, 32);
    const EffectPicture without = effect_picture(scene, 32, "-cutouts");
    CHECK(count_different(with.image, without.image) > 0);
    for (const glm::vec3& pixel : with.image.pixels) {
        CHECK(pixel.x > 0.5f); // no shadow is seen
    }
    CHECK(with.tally.camera == without.tally.camera);
    // A scene without them is the same with and without the effect, bit for bit.
    const Scene plain = add_mesh(white_scene(), facing_wall(0.0f, 1.0f), Material{});
    CHECK(!has(make_plan(plain, 1.0, "", {}), Effect::cutouts));
    CHECK(count_different(effect_picture(plain, 16).image,
                          effect_picture(plain, 16, "+cutouts").image) == 0);
}

TEST_CASE("holes are found in pictures and what cuts nothing is left out", "[09][cutouts]") {
    const LeafPicture picture;
    Scene scene = leaf_scene(picture);
    CHECK(find_cutouts(scene).materials[0].cutout_map == picture.path());
    scene.materials[0].cutoff = 0.0f;
    CHECK(find_cutouts(scene).materials[0].cutout_map.empty());
    scene.materials[0].cutoff = 0.5f;
    scene.materials[0].cutout_map = "gone.png";
    const Scene without = find_cutouts(scene);
    CHECK(without.materials[0].cutout_map.empty());
    REQUIRE(without.messages.size() == 1);
    CHECK_THAT(without.messages[0], contains_text("Material leaf: it has no holes. gone.png"));
    // A texture without an alpha channel cuts nothing, black as it may be.
    scene.materials[0].cutout_map.clear();
    scene.materials[0].diffuse_map = picture.path();
    CHECK(find_cutouts(scene).materials[0].cutout_map.empty());
    // An uncompressed TGA file of two texels in BGRA, the second of which is clear.
    const ScratchFolder folder("clear_texel");
    std::string tga(18, '\0');
    tga[2] = 2;
    tga[12] = 2;
    tga[14] = 1;
    tga[16] = 32;
    tga[17] = 0x28;
    put_bytes(folder / "two.tga", tga + std::string("\0\xff\0\xff\xff\0\0\0", 8));
    scene.materials[0].diffuse_map = (folder / "two.tga").string();
    CHECK(find_cutouts(scene).materials[0].cutout_map == scene.materials[0].diffuse_map);
    CHECK(read_picture(folder / "two.tga").pixels ==
          std::vector<glm::vec3>{glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)});
}

TEST_CASE("colours of corners tint a surface and call for nothing where there are none",
          "[09][plan]") {
    const auto context = make_context(ContextKind::automatic);
    Material white;
    white.diffuse = glm::vec3(1.0f);
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 4.0f), white);
    scene.lights = {{{0.0f, 0.0f, 4.0f}, glm::vec3(1.0f)}};
    const Image plain = effect_picture(scene, 17).image;
    CHECK(!has(make_plan(scene, 1.0, "", {}), Effect::vertex_colors));
    CHECK(count_different(plain, effect_picture(scene, 17, "+vertex_colors").image) == 0);
    scene.corner_colors.assign(6, glm::vec3(0.5f, 0.25f, 1.0f));
    const EffectPicture tinted = effect_picture(scene, 17);
    CHECK(has(tinted.plan, Effect::vertex_colors));
    CHECK(count_different(plain, effect_picture(scene, 17, "-vertex_colors").image) == 0);
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
        // The three weights of a point add up to 1 but for their rounding.
        CHECK(glm::distance(tinted.image.pixels[i],
                            plain.pixels[i] * glm::vec3(0.5f, 0.25f, 1.0f)) < 1e-6f);
    }
    // Between a black and a white corner lies grey: the middle is on the diagonal of the quad.
    scene.corner_colors = {glm::vec3(0), glm::vec3(0), glm::vec3(1),
                           glm::vec3(0), glm::vec3(1), glm::vec3(0)};
    const Image between = effect_picture(scene, 17).image;
    CHECK(between.at(8, 8).x == Approx(0.5f * plain.at(8, 8).x).epsilon(1e-5));
}
