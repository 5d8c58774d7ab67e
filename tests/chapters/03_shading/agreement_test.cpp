#include "catch.h"
#include "image/difference.h"
#include "mirror/walks.h"
#include "mirror/whitted.h"
#include "reference/whitted.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "support/expected_picture.h"
#include "support/same_bits.h"
#include "support/whitted_by_gpu.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace raysteps;

namespace {

std::size_t count_different_bits(const Image& a, const Image& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        different += same_bits(a.pixels[i], b.pixels[i]) ? 0 : 1;
    }
    return different;
}

} // namespace

TEST_CASE("the wavefront and its mirror paint the same bits", "[03][agreement]") {
    const auto context = make_context(ContextKind::automatic);
    for (const std::string name : {"cornell_box", "mirrors", "compact:4", "knot:1"}) {
        CAPTURE(name);
        const Scene scene = load_scene(name, 1.0f);
        const mirror::SceneBuffers buffers(scene);
        auto mirror = mirror::mirror_of<mirror::walks::every_triangle<float>>(buffers);
        const Image expected =
            mirror::render_whitted_by_mirror(mirror, scene, view_of(scene.camera, 1.0), 48, 48, 5);
        CHECK(count_different_bits(whitted_by_gpu(scene, 48, 48, 5), expected) == 0);
    }
}

TEST_CASE("the wavefront paints what the recursive reference paints", "[03][reference]") {
    const auto context = make_context(ContextKind::automatic);
    const int side = 64;
    for (const std::string name : {"cornell_box", "mirrors", "compact:4", "knot:1"}) {
        CAPTURE(name);
        const Scene scene = load_scene(name, 1.0f);
        const Image image = whitted_by_gpu(scene, side, side, 5);
        const Scene plain = without_optics(scene);
        const TreeLimits limits{.max_bounces = 5};
        const Image expected = render_whitted(plain, side, side, limits);
        // In float a ray is off by about 2^-20 of its length, more after each mirror; a thousandth
        // of a pixel is many times that. Where so small a move changes the colour, an edge or a
        // shadow's border passes.
        const std::vector<double> sensitivity =
            whitted_sensitivity(plain, side, side, limits, 1e-3);
        std::size_t excused = 0;
        double worst = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const glm::vec3 apart = glm::abs(image.pixels[i] - expected.pixels[i]);
            const double difference = std::max({apart.x, apart.y, apart.z});
            const bool steep = sensitivity[i] > 0.01;
            excused += steep && difference > 1e-3 ? 1 : 0;
            worst = steep ? worst : std::max(worst, difference);
        }
        std::cout << "03: " << name << ": " << excused << " of " << image.pixels.size()
                  << " pixels differ at an edge, else by " << worst << " at most\n";
        // Half a step of an 8-bit picture in the dark, where steps are smallest, is 1.5e-4; light
        // is summed from a few products, so 1e-3 leaves room for what curved mirrors magnify.
        CHECK(worst < 1e-3);
        CHECK(excused < image.pixels.size() / 100);
    }
}

TEST_CASE("a scene of any size gives the same picture bit for bit", "[03][hard_case]") {
    // A power of two changes no bit of a float but its exponent: what differs has overflowed or
    // underflowed. (Far below 2^-30, products are under least_product of real/float.glsl,
    // and the areas are no longer exact.)
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene("mirrors", 1.0f);
    const Image expected = whitted_by_gpu(scene, 32, 32, 3);
    for (const int exponent : {-30, -20, 20, 40, 50}) {
        CAPTURE(exponent);
        Scene scaled = scene;
        const auto scale = [&](glm::vec3& point) { point *= std::ldexp(1.0f, exponent); };
        std::for_each(scaled.corners.begin(), scaled.corners.end(), scale);
        scale(scaled.camera.eye);
        scale(scaled.camera.target);
        for (Light& light : scaled.lights) {
            scale(light.position);
        }
        CHECK(count_different_bits(whitted_by_gpu(scaled, 32, 32, 3), expected) == 0);
    }
}

TEST_CASE("the picture of chapter 03 is the expected one", "[03][picture]") {
    const auto context = make_context(ContextKind::automatic);
    const Image image = whitted_by_gpu(load_scene("mirrors", 1.0f), 256, 256, 8);
    // What the driver of another machine rounds otherwise can move single pixels at edges.
    CHECK(unexpected_pixels(image, "03_shading") <= 256 * 256 / 1000);
}
