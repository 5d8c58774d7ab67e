#include "basics/error.h"
#include "basics/random_numbers.h"
#include "gpu/context.h"
#include "hard_cases/hard_cases.h"
#include "tally.h"
#include "trials.h"

#include <algorithm>
#include <limits>

namespace raysteps {

namespace {

std::vector<Hit> hits_in_launches(const Scene& scene, std::span<const Ray> rays, TraceRays trace) {
    return read_hits(trace.closest_hits(upload_rays(rays), upload(scene)), rays.size());
}

// Loops that stop silently: walks are cut into launches before that, and go on in the next one.
std::vector<TrialRow> cut_walks(const TrialTools& tools) {
    if (tools.gpu == nullptr) {
        return {};
    }
    const HardScene made = find_hard_case("T13").make({2000, tools.seed});
    const Scene scene = add_mesh(Scene{}, made.mesh, Material{});
    const Parts parts{{"triangle", "triangle/watertight.glsl"}};
    const int budget = tools.gpu->limits().loop_budget;
    std::vector<TrialRow> rows{
        {"the loops", "GPU", "1,024 rounds at least",
         (budget >= no_loop_limit ? "no limit found up to " : "stop after ") +
             std::to_string(budget),
         budget >= 1024 ? Verdict::pass : Verdict::fail, 1,
         budget >= 1024 ? std::size_t{0} : std::size_t{1}}};
    const std::vector<Hit> whole =
        hits_in_launches(scene, made.rays, TraceRays(parts, tools.gpu->limits()));
    for (const int rounds : {1, 7, 64}) {
        const std::vector<Hit> cut = hits_in_launches(scene, made.rays, TraceRays(parts, rounds));
        rows.push_back(promised_row(std::to_string(rounds) + " rounds a launch", "GPU",
                                    "the bits of a whole walk", count_other_hits(cut, whole),
                                    cut.size()));
    }
    return rows;
}

// Numbers on their way through textures: an exact t, and numbers that a GPU could flush.
std::vector<TrialRow> bits_in_textures(const TrialTools& tools) {
    if (tools.gpu == nullptr) {
        return {};
    }
    RandomNumbers numbers(tools.seed);
    std::vector<Ray> rays;
    for (int i = 0; i < 1000; ++i) {
        rays.push_back({numbers.in_cube(), 1e-30f * numbers.in_cube(), -0.0f,
                        std::numeric_limits<float>::infinity()});
    }
    const std::vector<Ray> back = read_rays(upload_rays(rays), rays.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        different += rays[i].origin == back[i].origin && rays[i].direction == back[i].direction &&
                             rays[i].t_min == back[i].t_min && rays[i].t_max == back[i].t_max
                         ? 0
                         : 1;
    }
    return {promised_row("textures", "GPU", "the numbers of C++", different, rays.size())};
}

} // namespace

std::vector<Trial> platform_checks() {
    return {
        {"L1", "OpenGL may stop a loop silently: a walk goes on in another launch", "",
         "keep the position of the walk in a texture", cut_walks},
        {"L2", "numbers come back from textures as they went in", "", "", bits_in_textures},
    };
}

} // namespace raysteps
