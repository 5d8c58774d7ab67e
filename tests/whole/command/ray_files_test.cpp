#include "catch.h"
#include "programs.h"
#include "ray_bytes.h"

#include <cstdint>
#include <limits>

namespace {

struct HitNumbers {
    float t;
    float u;
    float v;
    std::int32_t triangle;

    bool operator==(const HitNumbers&) const = default;
};

std::vector<HitNumbers> hits_of(const std::string& bytes) {
    REQUIRE(bytes.size() % sizeof(HitNumbers) == 0);
    std::vector<HitNumbers> hits(bytes.size() / sizeof(HitNumbers));
    if (!hits.empty()) {
        std::memcpy(hits.data(), bytes.data(), bytes.size());
    }
    return hits;
}

constexpr float infinity = std::numeric_limits<float>::infinity();

// Numbers whose products and quotients are exact, so the hits are known to the bit.
const std::vector<RayNumbers> rays{
    {0.25f, 0.5f, 1.0f, 0.0f, 0.0f, -1.0f, 0.0f, 100.0f},    // meets the upper triangle
    {0.25f, 0.5f, 1.0f, 0.0f, 0.0f, -1.0f, 1.5f, infinity},  // begins behind it
    {0.25f, 0.25f, 3.0f, 0.0f, 0.0f, -2.0f, 0.0f, infinity}, // its direction has length 2
    {2.0f, 2.0f, 1.0f, 0.0f, 0.0f, -1.0f, 0.0f, 7.0f},       // passes by
    {0.25f, 0.25f, 1.0f, 0.0f, 0.0f, -1.0f, 0.0f, 0.5f},     // ends before
    {0.5f, 0.25f, -4.0f, 0.0f, 0.0f, 1.0f, 0.0f, infinity}}; // comes from below

const std::vector<HitNumbers> known_hits{{1.0f, 0.25f, 0.5f, 0},  {2.0f, 0.25f, 0.5f, 1},
                                         {1.5f, 0.25f, 0.25f, 0}, {7.0f, 0.0f, 0.0f, -1},
                                         {0.5f, 0.0f, 0.0f, -1},  {3.0f, 0.5f, 0.25f, 1}};

Outcome trace(const Workplace& workplace, const std::string& chapter, const std::string& rays_file,
              const std::string& hits_file) {
    return workplace.run(chapter, {"--scene", "two.obj", "--rays", rays_file, "--hits", hits_file});
}

} // namespace

TEST_CASE("rays of a file need no camera in front of a scene that is too large for one",
          "[command]") {
    const Workplace workplace("rays_too_large");
    workplace.write("large.obj", "v -1e18 -1e18 0\nv 1e18 -1e18 0\nv 0 1e18 0\nf 1 2 3\n");
    workplace.write("rays.f32",
                    ray_bytes({{0.0f, 0.0f, 1e18f, 0.0f, 0.0f, -1e18f, 0.0f, infinity}}));
    for (const std::string chapter : {"02_triangles", "09_effects"}) {
        const Outcome outcome = workplace.run(
            chapter, {"--scene", "large.obj", "--rays", "rays.f32", "--hits", "hits.f32"});
        CAPTURE(chapter, outcome.errors);
        CHECK(outcome.exit_code == 0);
        CHECK(hits_of(workplace.read("hits.f32")) ==
              std::vector<HitNumbers>{{1.0f, 0.25f, 0.5f, 0}});
    }
    CHECK(workplace
              .run("02_triangles", {"--scene", "large.obj", "--size", "8", "--camera",
                                    "0,0,1.5e18,0,0,0", "--context", "osmesa"})
              .exit_code == 0);
    check_refusal(workplace, "02_triangles", {"--scene", "large.obj"}, 2,
                  {"large: this is too large for a camera", "--camera", "[camera]", "scale ="});
}

TEST_CASE("directions whose t is no normal float are said once", "[command]") {
    const Workplace workplace("rays_unusual");
    workplace.write("two.obj", two_triangles);
    std::vector<RayNumbers> unusual(3, rays[0]);
    unusual[1][5] = -1e37f;
    unusual[2][3] = 1e-40f;
    workplace.write("rays.f32", ray_bytes(unusual));
    const Outcome outcome = trace(workplace, "02_triangles", "rays.f32", "hits.f32");
    CHECK(outcome.exit_code == 0);
    const std::string sentence = "rays.f32: 2 of 3 rays (the first is ray 1, from 0)";
    CHECK_THAT(outcome.errors, contains_text(sentence));
    CHECK(outcome.errors.find(sentence) == outcome.errors.rfind(sentence));
    workplace.write("rays.f32", ray_bytes(rays));
    CHECK_THAT(trace(workplace, "02_triangles", "rays.f32", "hits.f32").errors,
               !contains_text("rays.f32: "));
}

TEST_CASE("the rays of a binary file give the known hits", "[command]") {
    const Workplace workplace("rays_good_binary");
    workplace.write("two.obj", two_triangles);
    workplace.write("rays.f32", ray_bytes(rays));
    for (const std::string chapter : {"02_triangles", "03_shading"}) {
        const Outcome outcome = trace(workplace, chapter, "rays.f32", "hits.f32");
        CAPTURE(chapter, outcome.errors);
        CHECK(outcome.exit_code == 0);
        CHECK_THAT(outcome.output, contains_text("hits.f32, 6 hits\n"));
        CHECK(hits_of(workplace.read("hits.f32")) == known_hits);
    }
}

TEST_CASE("a scene too small for floats has the known hits where it and the rays are scaled",
          "[command]") {
    const Workplace workplace("rays_scaled");
    // The same triangles and rays, times 2^-60 = 8.67361738e-19: exact, as all numbers here are.
    workplace.write("two.obj", "v 0 0 0\nv 8.67361738e-19 0 0\nv 0 8.67361738e-19 0\n"
                               "v 0 0 -8.67361738e-19\nv 8.67361738e-19 0 -8.67361738e-19\n"
                               "v 0 8.67361738e-19 -8.67361738e-19\nf 1 2 3\nf 4 5 6\n");
    std::vector<RayNumbers> small = rays;
    for (RayNumbers& ray : small) {
        for (std::size_t i = 0; i < 6; ++i) {
            ray[i] *= 0x1p-60f;
        }
    }
    workplace.write("rays.f32", ray_bytes(small));
    const Outcome warned = trace(workplace, "02_triangles", "rays.f32", "hits.f32");
    CHECK_THAT(warned.errors, contains_text("Add --scale-exponent 60"));
    const Outcome outcome =
        workplace.run("02_triangles", {"--scene", "two.obj", "--rays", "rays.f32", "--hits",
                                       "hits.f32", "--scale-exponent", "60"});
    CAPTURE(outcome.errors);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.errors, !contains_text("--scale-exponent"));
    CHECK(hits_of(workplace.read("hits.f32")) == known_hits);
}

TEST_CASE("rays and hits as text agree with those in binary", "[command]") {
    const Workplace workplace("rays_good_text");
    workplace.write("two.obj", two_triangles);
    workplace.write("rays.csv",
                    "t_max,t_min,direction_x,direction_y,direction_z,origin_x,origin_y,origin_z\n"
                    "100,0,0,0,-1,0.25,0.5,1\n"
                    "inf,1.5,0,0,-1,0.25,0.5,1\r\n"
                    "inf,0,0,0,-2,0.25,0.25,3\n"
                    "\n"
                    "7,0,0,0,-1,2,2,1\n"
                    "0.5,0,0,0,-1,0.25,0.25,1\n"
                    "inf,0,0,0,1,0.5,0.25,-4");
    CHECK(trace(workplace, "02_triangles", "rays.csv", "hits.f32").exit_code == 0);
    CHECK(hits_of(workplace.read("hits.f32")) == known_hits);
    CHECK(trace(workplace, "02_triangles", "rays.csv", "hits.csv").exit_code == 0);
    CHECK(workplace.read("hits.csv") == "t,u,v,triangle,name\n"
                                        "1,0.25,0.5,0,\"two.obj, face 1\"\n"
                                        "2,0.25,0.5,1,\"two.obj, face 2\"\n"
                                        "1.5,0.25,0.25,0,\"two.obj, face 1\"\n"
                                        "7,0,0,-1,\n"
                                        "0.5,0,0,-1,\n"
                                        "3,0.5,0.25,1,\"two.obj, face 2\"\n");
}

TEST_CASE("no rays give no hits", "[command]") {
    const Workplace workplace("rays_none");
    workplace.write("two.obj", two_triangles);
    workplace.write("rays.f32", "");
    workplace.write("rays.csv", "origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,"
                                "t_min,t_max\n");
    CHECK(trace(workplace, "02_triangles", "rays.f32", "hits.f32").exit_code == 0);
    CHECK(workplace.read("hits.f32").empty());
    CHECK(trace(workplace, "02_triangles", "rays.csv", "hits.csv").exit_code == 0);
    CHECK(workplace.read("hits.csv") == "t,u,v,triangle,name\n");
}
