#include "catch.h"
#include "gpu/context.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/fuzz.h"
#include "hard_cases/hard_cases.h"
#include "scene/load_scene.h"
#include "scene/ray_file.h"
#include "support/scratch_folder.h"

#include <algorithm>
#include <limits>

using namespace raysteps;

namespace {

// A walk that cannot see one place: it loses every hit of a triangle with a corner there.
FuzzMethod blind_walk(const glm::vec3& place) {
    return {"blind", [place](const HardScene& made) {
                std::vector<Hit> hits = fuzz_methods().front().trace(made);
                for (Hit& hit : hits) {
                    for (int corner = 0; hit.triangle >= 0 && corner < 3; ++corner) {
                        const std::size_t i = 3 * static_cast<std::size_t>(hit.triangle);
                        const auto at = static_cast<std::size_t>(corner);
                        if (made.mesh.corners[i + at] == place) {
                            hit = {no_end, 0.0f, 0.0f, no_triangle};
                        }
                    }
                }
                return hits;
            }};
}

std::vector<FuzzMethod> with_blind_walk(const glm::vec3& place) {
    return {fuzz_methods().front(), blind_walk(place)};
}

void check_fuzz(const FuzzRequest& request) {
    const FuzzResult result = fuzz(request);
    CAPTURE(request.first_seed, result.scenes);
    if (result.fault) {
        const auto paths = write_fault(*result.fault, RAYSTEPS_BINARY_DIR);
        CAPTURE(result.fault->seed, result.fault->method, result.fault->what, paths[0], paths[1]);
        CHECK_FALSE(result.fault.has_value());
    }
    CHECK(result.scenes > 0);
}

} // namespace

TEST_CASE("random scenes and garbage bits find no fault in any structure", "[hard_cases][fuzz]") {
    const auto context = make_context(ContextKind::automatic);
    GpuMethods gpu(measure_limits());
    check_fuzz({.first_seed = 1, .seconds = 20.0, .gpu = &gpu});
}

TEST_CASE("ten minutes of random scenes and garbage bits find no fault in any structure",
          "[.][long]") {
    const auto context = make_context(ContextKind::automatic);
    GpuMethods gpu(measure_limits());
    check_fuzz({.first_seed = 1000000, .seconds = 600.0, .gpu = &gpu});
}

TEST_CASE("a walk that loses one triangle is found and shrunk to it", "[hard_cases][fuzz]") {
    int found = 0;
    for (int seed = 1; seed < 20; ++seed) {
        CAPTURE(seed);
        const HardScene made = awkward_scene(seed);
        const std::vector<Hit> hits = fuzz_methods().front().trace(made);
        const auto any = std::find_if(hits.begin(), hits.end(),
                                      [](const Hit& hit) { return hit.triangle >= 0; });
        if (any == hits.end()) {
            continue;
        }
        const glm::vec3 place = made.mesh.corners[3 * static_cast<std::size_t>(any->triangle)];
        const std::vector<FuzzMethod> methods = with_blind_walk(place);
        auto fault = find_different_hit(made, methods);
        REQUIRE(fault.has_value());
        const FuzzFault small = shrink(*fault, methods, find_different_hit);
        CHECK(small.made.rays.size() == 1);
        CHECK(small.made.mesh.corners.size() == 3);
        CHECK(small.method == "blind");
        ++found;
    }
    CHECK(found > 5);
}

TEST_CASE("a fault's files hold its triangles and rays", "[hard_cases][fuzz]") {
    const ScratchFolder folder("fault_files");
    FuzzFault fault{5, "blind", "", awkward_scene(11)};
    REQUIRE(fault.made.mesh.corners.size() >= 3);
    const auto paths = write_fault(fault, folder / "");
    const Scene scene = load_scene(paths[0].string(), 1.0f);
    CHECK(triangle_count(scene) > 0);
    const std::vector<Ray> rays = read_ray_file(paths[1]);
    REQUIRE(rays.size() == fault.made.rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        CHECK(rays[i].origin == fault.made.rays[i].origin);
        CHECK(rays[i].direction == fault.made.rays[i].direction);
        CHECK(rays[i].t_max == fault.made.rays[i].t_max);
    }
}

TEST_CASE("every builder refuses a scene that is not finite", "[hard_cases][fuzz]") {
    const std::vector<FuzzMethod> methods = fuzz_methods();
    HardScene made = awkward_scene(11);
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        made.mesh.corners[1].y = bad;
        CHECK_FALSE(is_finite(made.mesh));
        CHECK_FALSE(find_no_answer(made, methods).has_value());
    }
    // The loop has no builder, so it takes what is given: that is what the finder would tell.
    const std::vector<FuzzMethod> careless{methods.front(), methods.front()};
    CHECK(find_no_answer(made, careless).has_value());
}
