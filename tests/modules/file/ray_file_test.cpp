#include "scene/ray_file.h"

#include "basics/random_numbers.h"
#include "catch.h"
#include "support/scratch_folder.h"

#include <cstring>
#include <limits>

using namespace raysteps;

TEST_CASE("rays that were written come back with the same bits", "[scene][rays]") {
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < 100; ++i) {
        rays.push_back({numbers.in_cube() * 1e-7f, numbers.in_cube() * 1e20f, numbers.unit(),
                        std::numeric_limits<float>::infinity()});
    }
    rays[3].origin.x = -0.0f;
    const ScratchFolder folder("ray_files");
    for (const std::string name : {"rays.csv", "rays.f32"}) {
        CAPTURE(name);
        write_ray_file(folder / name, rays);
        const std::vector<Ray> again = read_ray_file(folder / name);
        REQUIRE(again.size() == rays.size());
        CHECK(std::memcmp(again.data(), rays.data(), rays.size() * sizeof(Ray)) == 0);
    }
}
