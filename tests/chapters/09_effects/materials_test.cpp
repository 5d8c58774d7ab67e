#include "catch.h"
#include "effect_pictures.h"
#include "scene/obj/load_obj.h"

#include <algorithm>
#include <cmath>

using namespace raysteps;

TEST_CASE("bad materials are corrected with file and line and render without NaN",
          "[09][materials][hard_case]") {
    const auto context = make_context(ContextKind::automatic);
    const ParsedMtl parsed = parse_mtl("newmtl bad\n"
                                       "illum 7\n"
                                       "Ni 0\n"
                                       "Kd -1 0.5 0.5\n"
                                       "Ks 1 1 1\n"
                                       "Ns inf\n"
                                       "d 2\n",
                                       "bad.mtl", ".");
    const auto names_line = [&](const std::string& place, const std::string& keyword) {
        return std::any_of(
            parsed.messages.begin(), parsed.messages.end(), [&](const std::string& message) {
                return message.starts_with(place) && message.find(keyword) != std::string::npos;
            });
    };
    CHECK(names_line("bad.mtl:3: ", "Ni \"0\""));
    CHECK(names_line("bad.mtl:4: ", "Kd \"-1\""));
    CHECK(names_line("bad.mtl:6: ", "Ns \"inf\""));
    CHECK(names_line("bad.mtl:7: ", "d \"2\""));
    REQUIRE(parsed.materials.size() == 1);
    const Material& material = parsed.materials[0];
    CHECK(material.refractive_index == 1.0f);
    CHECK(material.diffuse.x == 0.0f);
    CHECK(material.opacity == 1.0f);
    Scene scene = add_mesh(white_scene(), sphere({0, 0, 0}, 0.6f, 3), material);
    scene.lights = {{{2, 3, 4}, glm::vec3(1.0f)}};
    for (const glm::vec3& pixel : effect_picture(scene, 16).image.pixels) {
        CHECK((std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z)));
    }
}
