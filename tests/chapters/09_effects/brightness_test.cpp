#include "catch.h"
#include "effect_pictures.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace raysteps;

namespace {

double to_srgb(double value) {
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

} // namespace

TEST_CASE("half of a sample scene's picture is neither dark nor white and little is clipped",
          "[09][light]") {
    const auto context = make_context(ContextKind::automatic);
    for (const char* name : {"cornell_box", "mirrors", "sphereflake:2", "glass_box", "pictures",
                             "soft_light", "lens", "room", "compact:4", "knot:1", "soup:500",
                             "needles:200", "tetrahedron:3", "mount:3", "stadium:1"}) {
        CAPTURE(name);
        const Image image = effect_picture(load_scene(name, 1.0f), 32).image;
        std::vector<double> brightness;
        long clipped = 0;
        for (const glm::vec3& pixel : image.pixels) {
            const glm::dvec3 color(pixel);
            brightness.push_back(to_srgb(0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z));
            clipped += std::max({pixel.x, pixel.y, pixel.z}) > 1.0f ? 1 : 0;
        }
        const auto middle = brightness.begin() + static_cast<std::ptrdiff_t>(brightness.size() / 2);
        std::nth_element(brightness.begin(), middle, brightness.end());
        CHECK(*middle > 0.15);
        CHECK(*middle < 0.7);
        CHECK(100 * clipped < 3 * static_cast<long>(image.pixels.size()));
    }
}
