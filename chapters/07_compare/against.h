#pragma once

#include "basics/statistics.h"
#include "basics/text.h"
#include "program/figures.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

inline const std::string compare_schema = "compare.schema.json";

// A file that --json of this chapter wrote.
struct EarlierRun {
    std::filesystem::path path;
    Numbers figures;
};

// Throws InputError where the file cannot be read, or is of another schema or version.
EarlierRun read_earlier_run(const std::filesystem::path& path);

// Both throw InputError where the earlier run traced other rays: in a picture of another size, by
// another triangle test, in scenes that lack or are not the same. Paths of scenes are named by
// their stems.
void check_request(const EarlierRun& earlier, const PictureSize& size, const std::string& triangle,
                   std::span<const std::string> scenes);
void check_scene(const EarlierRun& earlier, const SceneRecord& scene);

// What speeds are compared by. The clock of a machine that others use lies, and the time of its
// processors less; but that too depends on what the others do to caches and clock rates.
enum class Yardstick {
    embree,         // a walk's rate over that of rtcIntersect1 in the same rounds
    processor_time, // rays per second of processor time
    clock,          // where OpenGL has a GPU, and Embree took no part
};

// Embree, where it took part in both runs in the same version and mode; else a time, where the
// machine is the same (processor, cores, OpenGL). Throws InputError where there is none.
Yardstick choose_yardstick(const EarlierRun& earlier, const Numbers& now);

// One walk, kind of rays and scene in both runs.
struct ChangedRate {
    std::string scene;
    std::string kind;
    std::string contender;
    MeasuredRange then;
    MeasuredRange now;
    bool same_rays =
        true; // a slow walk is measured with a part of the rays, and not always as many
};

// All that both runs measured, in the order of the one that is now.
std::vector<ChangedRate> changed_rates(const Numbers& then, const Numbers& now,
                                       Yardstick yardstick);

// Of so many pairs of runs in which nothing changed, how many would be seen to be slower in every
// round, if their rounds were drawn from one hat: pairs / C(then + now, now).
double slower_by_chance(std::size_t pairs, int rounds_then, int rounds_now);

// For people: for each walk how fast it is now over how fast it was then, with the range. Beyond
// doubt is a walk slower where every round is slower than every round was, and chance would show
// that of any walk in fewer than one of 20 comparisons; on another machine nothing is.
struct AgainstReport {
    std::string text;
    std::size_t rates = 0;
    std::size_t slower = 0; // of them, beyond doubt
};

AgainstReport report_against(const EarlierRun& earlier, const Numbers& now);

} // namespace raysteps
