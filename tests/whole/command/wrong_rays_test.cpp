#include "catch.h"
#include "programs.h"
#include "ray_bytes.h"

#include <limits>

namespace {

const std::string header = "origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,"
                           "t_min,t_max\n";

void check_refused_rays(const Workplace& workplace, const std::string& file,
                        const std::string& bytes, const std::vector<std::string>& fragments) {
    workplace.write(file, bytes);
    check_refusal(workplace, "02_triangles",
                  {"--scene", "cornell_box", "--rays", file, "--hits", "hits.csv"}, 2, fragments);
}

} // namespace

TEST_CASE("a file of rays that is not there is refused", "[command][refusal]") {
    const Workplace workplace("rays_missing");
    check_refusal(workplace, "02_triangles", {"--rays", "lost.f32", "--hits", "h.f32"}, 2,
                  {"lost.f32: there is no such file"});
    check_refusal(workplace, "02_triangles", {"--rays", ".", "--hits", "h.f32"}, 2, {"folder"});
}

TEST_CASE("a binary file of rays with a fault is refused", "[command][refusal]") {
    const Workplace workplace("rays_binary");
    const RayNumbers good{0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f};
    RayNumbers nan = good;
    nan[4] = std::numeric_limits<float>::quiet_NaN();
    RayNumbers without_direction = good;
    without_direction[5] = 0.0f;
    check_refused_rays(workplace, "size.f32", ray_bytes({good}) + "1234567",
                       {"size.f32", "39 bytes", "32"});
    check_refused_rays(workplace, "nan.f32", ray_bytes({good, nan}),
                       {"nan.f32: ray 1", "not finite"});
    check_refused_rays(workplace, "direction.f32", ray_bytes({good, good, without_direction}),
                       {"direction.f32: ray 2", "no direction"});
}

TEST_CASE("a text file of rays with a fault is refused with its line", "[command][refusal]") {
    const Workplace workplace("rays_text");
    check_refused_rays(workplace, "empty.csv", "", {"empty.csv:1: ", "columns"});
    check_refused_rays(workplace, "column.csv",
                       "origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,t_min\n",
                       {"column.csv:1: ", "eight columns"});
    check_refused_rays(workplace, "name.csv", "origin_x,colour\n", {"name.csv:1: ", "`colour`"});
    check_refused_rays(workplace, "cell.csv", header + "0,0,0,0,0,1,0,1\n0,0,zero,0,0,1,0,1\n",
                       {"cell.csv:3: ", "`zero`"});
    check_refused_rays(workplace, "short.csv", header + "0,0,0,0,0,1,0\n",
                       {"short.csv:2: ", "7 cells"});
    check_refused_rays(workplace, "direction.csv", header + "0,0,0,0,0,0,0,1\n",
                       {"direction.csv: ray 0", "no direction"});
}
