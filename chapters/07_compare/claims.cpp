#include "claims.h"

#include "gpu/shaders.h"
#include "render/trace_rays.h"
#include "structure/structure.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>

namespace raysteps {

namespace {

const std::string grid = "grid";
const std::string kd = "kd";
const std::string bvh = "bvh";

// The rates of the three families in one scene.
struct Rivals {
    RayCosts grid;
    RayCosts kd;
    RayCosts bvh;
};

// Whatever options it was built with.
bool is_in_family(const std::string& contender, const std::string& family) {
    const std::string structure = contender.substr(0, contender.find(':'));
    return structure == family || structure.starts_with(family + "_");
}

std::string words_of(const RayCosts& row) {
    return fmt::format("{} {:.3g} ({:.3g} to {:.3g})", row.contender, row.rate.median,
                       row.rate.lowest, row.rate.highest);
}

ClaimVerdict faster(const RayCosts& expected, const RayCosts& other) {
    if (is_faster(expected.rate, other.rate)) {
        return ClaimVerdict::holds;
    }
    return is_faster(other.rate, expected.rate) ? ClaimVerdict::does_not_hold
                                                : ClaimVerdict::ranges_overlap;
}

// Of two verdicts that both have to hold.
ClaimVerdict both(ClaimVerdict a, ClaimVerdict b) {
    if (a == ClaimVerdict::does_not_hold || b == ClaimVerdict::does_not_hold) {
        return ClaimVerdict::does_not_hold;
    }
    return a == b ? a : ClaimVerdict::ranges_overlap;
}

ClaimVerdict opposite(ClaimVerdict verdict) {
    if (verdict == ClaimVerdict::ranges_overlap) {
        return verdict;
    }
    return verdict == ClaimVerdict::holds ? ClaimVerdict::does_not_hold : ClaimVerdict::holds;
}

ClaimVerdict grid_slowest(const std::string& scene, const Rivals& rivals) {
    const ClaimVerdict slowest =
        both(faster(rivals.kd, rivals.grid), faster(rivals.bvh, rivals.grid));
    return is_single_object(scene) ? opposite(slowest) : slowest;
}

ClaimVerdict kd_before_grid(const std::string&, const Rivals& rivals) {
    return faster(rivals.kd, rivals.grid);
}

ClaimVerdict bvh_fastest(const std::string&, const Rivals& rivals) {
    return both(faster(rivals.bvh, rivals.grid), faster(rivals.bvh, rivals.kd));
}

std::optional<Rivals> rivals_of(const SceneCosts& result, const std::string& kind) {
    const auto best_grid = best_of_family(result, kind, grid);
    const auto best_kd = best_of_family(result, kind, kd);
    const auto best_bvh = best_of_family(result, kind, bvh);
    if (!best_grid || !best_kd || !best_bvh) {
        return std::nullopt;
    }
    return Rivals{*best_grid, *best_kd, *best_bvh};
}

enum class Quantifier { all, most };

struct SpeedClaim {
    std::string words;
    ClaimVerdict (*judge)(const std::string& scene, const Rivals& rivals);
    Quantifier quantifier;
};

const std::vector<SpeedClaim> speed_claims{
    {"the grid is the slowest, except for a single object", grid_slowest, Quantifier::all},
    {"for most scenes the kd-tree is faster than the grid", kd_before_grid, Quantifier::most},
    {"the BVH is the fastest", bvh_fastest, Quantifier::all},
};

ClaimVerdict sum_up(const std::vector<ClaimCase>& cases, Quantifier quantifier) {
    const auto count = [&](ClaimVerdict verdict) {
        return std::count_if(cases.begin(), cases.end(),
                             [&](const ClaimCase& one) { return one.verdict == verdict; });
    };
    const auto in_favour = count(ClaimVerdict::holds);
    const auto against = count(ClaimVerdict::does_not_hold);
    if (in_favour + against == 0) {
        return ClaimVerdict::ranges_overlap;
    }
    const bool holds = quantifier == Quantifier::all ? against == 0 : in_favour > against;
    return holds ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
}

const ProgramLength* shortest_of(std::span<const ProgramLength> programs,
                                 const std::string& family) {
    const ProgramLength* shortest = nullptr;
    for (const ProgramLength& program : programs) {
        if (is_in_family(program.structure, family) &&
            (shortest == nullptr || program.lines < shortest->lines)) {
            shortest = &program;
        }
    }
    return shortest;
}

std::vector<std::string> files_of(const std::string& structure) {
    Parts parts = walk_parts("watertight", structure);
    parts["real"] = "real/float.glsl";
    parts["cutout"] = "cutout/none.glsl";
    return read_shader(find_pass(has_packets(structure) ? "trace_packets" : "trace"), parts).files;
}

int count_lines(const std::string& file) {
    std::ifstream text(shader_folder() / file);
    int lines = 0;
    std::string line;
    while (std::getline(text, line)) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const bool says_something = begin != std::string::npos && line.compare(begin, 2, "//") != 0;
        lines += says_something ? 1 : 0;
    }
    return lines;
}

} // namespace

std::vector<std::string> kinds_of(std::span<const SceneCosts> results) {
    std::vector<std::string> kinds;
    for (const SceneCosts& result : results) {
        for (const RayCosts& row : result.rays) {
            if (std::find(kinds.begin(), kinds.end(), row.kind) == kinds.end()) {
                kinds.push_back(row.kind);
            }
        }
    }
    return kinds;
}

std::string to_words(ClaimVerdict verdict) {
    if (verdict == ClaimVerdict::ranges_overlap) {
        return "ranges overlap";
    }
    return verdict == ClaimVerdict::holds ? "holds" : "does not hold";
}

std::optional<RayCosts> best_of_family(const SceneCosts& result, const std::string& kind,
                                       const std::string& family) {
    std::optional<RayCosts> best;
    for (const RayCosts& row : result.rays) {
        if (row.kind == kind && is_in_family(row.contender, family) &&
            (!best || row.rate.median > best->rate.median)) {
            best = row;
        }
    }
    return best;
}

bool is_single_object(const std::string& scene) {
    const std::string name = scene.substr(0, scene.find(':'));
    return name == "compact" || name == "bunny";
}

std::vector<ClaimResult> judge_speed(std::span<const SceneCosts> results) {
    std::vector<ClaimResult> judged;
    const std::vector<std::string> kinds = kinds_of(results);
    for (const SpeedClaim& claim : speed_claims) {
        for (const std::string& kind : kinds) {
            ClaimResult result{.claim = claim.words, .kind = kind};
            for (const SceneCosts& scene : results) {
                if (const auto rivals = rivals_of(scene, kind)) {
                    result.cases.push_back({scene.scene, claim.judge(scene.scene, *rivals),
                                            words_of(rivals->grid) + ", " + words_of(rivals->kd) +
                                                ", " + words_of(rivals->bvh)});
                }
            }
            result.verdict = sum_up(result.cases, claim.quantifier);
            judged.push_back(std::move(result));
        }
    }
    return judged;
}

ClaimResult judge_simplicity(std::span<const ProgramLength> programs) {
    ClaimResult result{.claim = "the BVH is the simplest", .kind = "lines of GLSL"};
    const ProgramLength* shortest = nullptr;
    const ProgramLength* own = shortest_of(programs, bvh);
    std::string numbers;
    for (const std::string& family : {grid, kd, bvh}) {
        const ProgramLength* program = shortest_of(programs, family);
        if (program == nullptr) {
            return result;
        }
        if (shortest == nullptr || program->lines < shortest->lines) {
            shortest = program;
        }
        numbers += (numbers.empty() ? "" : ", ") + program->structure + " " +
                   std::to_string(program->lines);
    }
    result.verdict =
        own->lines == shortest->lines ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
    result.cases.push_back({"every scene", result.verdict, numbers});
    return result;
}

ProgramLength program_length(const std::string& structure) {
    const std::vector<std::string> common = files_of("every_triangle");
    ProgramLength length{structure, 0};
    for (const std::string& file : files_of(structure)) {
        if (std::find(common.begin(), common.end(), file) == common.end()) {
            length.lines += count_lines(file);
        }
    }
    return length;
}

} // namespace raysteps
