#include "claims.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

namespace {

const std::string grid = "grid";
const std::string kd = "kd";
const std::string bvh = "bvh";

// The rates of the three families in one scene.
struct Rivals {
    ContestRow grid;
    ContestRow kd;
    ContestRow bvh;
};

bool is_in_family(const std::string& structure, const std::string& family) {
    return structure == family || structure.starts_with(family + "_");
}

std::string words_of(const ContestRow& row) {
    return fmt::format("{} {:.3g} ({:.3g} to {:.3g})", row.contender, row.rate.median,
                       row.rate.lowest, row.rate.highest);
}

Verdict faster(const ContestRow& expected, const ContestRow& other) {
    if (is_faster(expected.rate, other.rate)) {
        return Verdict::holds;
    }
    return is_faster(other.rate, expected.rate) ? Verdict::does_not_hold : Verdict::ranges_overlap;
}

// Of two verdicts that both have to hold.
Verdict both(Verdict a, Verdict b) {
    if (a == Verdict::does_not_hold || b == Verdict::does_not_hold) {
        return Verdict::does_not_hold;
    }
    return a == b ? a : Verdict::ranges_overlap;
}

Verdict opposite(Verdict verdict) {
    if (verdict == Verdict::ranges_overlap) {
        return verdict;
    }
    return verdict == Verdict::holds ? Verdict::does_not_hold : Verdict::holds;
}

Verdict grid_slowest(const std::string& scene, const Rivals& rivals) {
    const Verdict slowest = both(faster(rivals.kd, rivals.grid), faster(rivals.bvh, rivals.grid));
    return is_single_object(scene) ? opposite(slowest) : slowest;
}

Verdict kd_before_grid(const std::string&, const Rivals& rivals) {
    return faster(rivals.kd, rivals.grid);
}

Verdict bvh_fastest(const std::string&, const Rivals& rivals) {
    return both(faster(rivals.bvh, rivals.grid), faster(rivals.bvh, rivals.kd));
}

std::optional<Rivals> rivals_of(const SceneResult& result, const std::string& kind) {
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
    Verdict (*judge)(const std::string& scene, const Rivals& rivals);
    Quantifier quantifier;
};

const std::vector<SpeedClaim> speed_claims{
    {"the grid is the slowest, except for a single object", grid_slowest, Quantifier::all},
    {"for most scenes the kd-tree is faster than the grid", kd_before_grid, Quantifier::most},
    {"the BVH is the fastest", bvh_fastest, Quantifier::all},
};

Verdict sum_up(const std::vector<ClaimCase>& cases, Quantifier quantifier) {
    const auto count = [&](Verdict verdict) {
        return std::count_if(cases.begin(), cases.end(),
                             [&](const ClaimCase& one) { return one.verdict == verdict; });
    };
    const auto in_favour = count(Verdict::holds);
    const auto against = count(Verdict::does_not_hold);
    if (in_favour + against == 0) {
        return Verdict::ranges_overlap;
    }
    const bool holds = quantifier == Quantifier::all ? against == 0 : in_favour > against;
    return holds ? Verdict::holds : Verdict::does_not_hold;
}

std::vector<std::string> kinds_of(std::span<const SceneResult> results) {
    std::vector<std::string> kinds;
    for (const SceneResult& result : results) {
        for (const ContestRow& row : result.rows) {
            if (std::find(kinds.begin(), kinds.end(), row.kind) == kinds.end()) {
                kinds.push_back(row.kind);
            }
        }
    }
    return kinds;
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

} // namespace

std::string to_words(Verdict verdict) {
    if (verdict == Verdict::ranges_overlap) {
        return "ranges overlap";
    }
    return verdict == Verdict::holds ? "holds" : "does not hold";
}

std::optional<ContestRow> best_of_family(const SceneResult& result, const std::string& kind,
                                         const std::string& family) {
    std::optional<ContestRow> best;
    for (const ContestRow& row : result.rows) {
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

std::vector<ClaimResult> judge_speed(std::span<const SceneResult> results) {
    std::vector<ClaimResult> judged;
    const std::vector<std::string> kinds = kinds_of(results);
    for (const SpeedClaim& claim : speed_claims) {
        for (const std::string& kind : kinds) {
            ClaimResult result{.claim = claim.words, .kind = kind};
            for (const SceneResult& scene : results) {
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
    result.verdict = own->lines == shortest->lines ? Verdict::holds : Verdict::does_not_hold;
    result.cases.push_back({"every scene", result.verdict, numbers});
    return result;
}

} // namespace raysteps
