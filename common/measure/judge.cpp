#include "measure/judge.h"

#include "basics/file.h"
#include "basics/random_numbers.h"
#include "scene/ray_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace raysteps {

namespace {

constexpr std::size_t sampled_rays = 1024;
constexpr std::size_t most_tests = 1U << 25U; // of triangles: about a quarter of a second
constexpr int sample_seed = 7;

// The answers by the numbers of the rays; null where somebody was not asked.
struct Witness {
    std::string name;
    std::vector<const Hit*> answers;
};

Witness witness_of(const Answers& own, std::size_t ray_count) {
    Witness witness{own.contender, std::vector<const Hit*>(ray_count, nullptr)};
    for (std::size_t i = 0; i < own.rays.size(); ++i) {
        witness.answers[own.rays[i]] = &own.hits[i];
    }
    return witness;
}

bool is_disputed(std::span<const Witness> witnesses, std::size_t ray, Query query) {
    const Hit* first = nullptr;
    for (const Witness& witness : witnesses) {
        const Hit* const answer = witness.answers[ray];
        if (first != nullptr && answer != nullptr && !is_same_answer(*first, *answer, query)) {
            return true;
        }
        first = first == nullptr ? answer : first;
    }
    return false;
}

std::vector<std::size_t> disputed_rays(std::span<const Witness> witnesses, const RayKind& kind) {
    std::vector<std::size_t> disputed;
    for (std::size_t i = 0; i < kind.rays.size(); ++i) {
        if (is_disputed(witnesses, i, kind.query)) {
            disputed.push_back(i);
        }
    }
    return disputed;
}

// Without repetition; those who were asked the same rays get the same sample.
std::vector<std::size_t> random_sample(std::vector<std::size_t> rays, std::size_t triangles) {
    const std::size_t affordable =
        std::max<std::size_t>(1, most_tests / std::max<std::size_t>(1, triangles));
    const std::size_t size = std::min({rays.size(), sampled_rays, affordable});
    RandomNumbers numbers(sample_seed);
    for (std::size_t i = 0; i < size; ++i) {
        std::swap(
            rays[i],
            rays[i + static_cast<std::size_t>(numbers.below(static_cast<int>(rays.size() - i)))]);
    }
    rays.resize(size);
    return rays;
}

Disagreement disagreement_of(const Witness& one, const Witness& other, Query query) {
    Disagreement disagreement{one.name, other.name};
    for (std::size_t i = 0; i < one.answers.size(); ++i) {
        if (one.answers[i] != nullptr && other.answers[i] != nullptr) {
            ++disagreement.of;
            disagreement.rays += is_same_answer(*one.answers[i], *other.answers[i], query) ? 0 : 1;
        }
    }
    return disagreement;
}

// The loop is the last witness, and its disagreements come first.
std::vector<Disagreement> disagreements_of(std::span<const Witness> witnesses, Query query) {
    std::vector<Disagreement> disagreements;
    for (std::size_t other = witnesses.size(); other-- > 1;) {
        for (std::size_t one = 0; one < other; ++one) {
            const Disagreement disagreement =
                disagreement_of(witnesses[one], witnesses[other], query);
            if (disagreement.rays > 0) {
                disagreements.push_back(disagreement);
            }
        }
    }
    return disagreements;
}

DisputedRay disputed_ray(std::span<const Witness> witnesses, const RayKind& kind,
                         std::size_t number) {
    DisputedRay disputed{number, kind.rays[number], {}, {}};
    for (const Witness& witness : witnesses) {
        if (witness.answers[number] != nullptr) {
            disputed.answers.emplace_back(witness.name, *witness.answers[number]);
        }
    }
    return disputed;
}

RayKind those_of(const RayKind& kind, const std::set<std::size_t>& numbers) {
    RayKind those{kind.name, kind.query, {}};
    for (const std::size_t number : numbers) {
        those.rays.push_back(kind.rays[number]);
    }
    return those;
}

// "a differs from the loop in 3 of 9 rays, b in 2 of 9; a differs from b in 1 of 12 rays"
std::string to_words(std::span<const Disagreement> disagreements) {
    std::string words;
    for (const Disagreement& one : disagreements) {
        words += fmt::format("{}{} differs from {} in {} of {}", words.empty() ? "" : ", ", one.one,
                             one.other, one.rays, one.of);
    }
    return words;
}

std::string sentence_of(const Dispute& dispute) {
    return fmt::format("{} of {} {} rays of {} have more than one answer: {}. With --triangle "
                       "watertight, that is a bug in Raysteps or in a driver; please report it.",
                       dispute.disputed, dispute.all_rays, dispute.kind, dispute.scene,
                       to_words(dispute.disagreements));
}

std::string csv_line(std::size_t ray, const std::string& who, double t, double u, double v,
                     int triangle) {
    return fmt::format("{},{},{:.9g},{:.9g},{:.9g},{}\n", ray, who, t, u, v, triangle);
}

} // namespace

bool is_same_answer(const Hit& a, const Hit& b, Query query) {
    if (a.triangle < 0 || b.triangle < 0 || query == Query::any) {
        return (a.triangle < 0) == (b.triangle < 0);
    }
    return std::memcmp(&a, &b, sizeof a) == 0;
}

Judgement judge(const Scene& scene, const RayKind& kind, std::span<const Answers> answers,
                const LoopOverTriangles& loop) {
    const std::size_t count = kind.rays.size();
    Judgement judgement;
    std::vector<Witness> witnesses;
    std::set<std::size_t> asked; // of the loop
    for (const Answers& own : answers) {
        witnesses.push_back(witness_of(own, count));
        const std::vector<std::size_t> sample =
            random_sample(own.rays, static_cast<std::size_t>(triangle_count(scene)));
        judgement.judged.push_back(sample.size());
        asked.insert(sample.begin(), sample.end());
    }
    std::vector<std::size_t> disputed = disputed_rays(witnesses, kind);
    asked.insert(disputed.begin(), disputed.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                          disputed.size(), most_disputed_rays)));
    const Answers truth{the_loop, {asked.begin(), asked.end()}, loop(those_of(kind, asked))};
    witnesses.push_back(witness_of(truth, count));
    disputed = disputed_rays(witnesses, kind);
    if (disputed.empty()) {
        return judgement;
    }
    Dispute dispute{.scene = scene.name,
                    .kind = kind.name,
                    .all_rays = count,
                    .disagreements = disagreements_of(witnesses, kind.query),
                    .disputed = disputed.size(),
                    .rays = {}};
    disputed.resize(std::min(disputed.size(), most_disputed_rays));
    std::vector<Ray> rays;
    for (const std::size_t number : disputed) {
        dispute.rays.push_back(disputed_ray(witnesses, kind, number));
        rays.push_back(kind.rays[number]);
    }
    const std::vector<ReferenceHit> exact = exact_nearest_hits(rays, scene.corners);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        dispute.rays[i].truth = exact[i];
    }
    judgement.dispute = std::move(dispute);
    return judgement;
}

DisputeError::DisputeError(Dispute dispute)
    : Error(ExitCode::check_failed, sentence_of(dispute)), dispute_(std::move(dispute)) {}

std::string to_table(const Dispute& dispute) {
    std::string table =
        fmt::format("\nWho differs from whom in {} rays of {}\n", dispute.kind, dispute.scene);
    for (const Disagreement& one : dispute.disagreements) {
        table += fmt::format("{:21} {:30} {} of {} rays\n", one.one, one.other, one.rays, one.of);
    }
    return table;
}

std::vector<std::filesystem::path> write_dispute(const std::filesystem::path& folder,
                                                 const Dispute& dispute) {
    std::vector<Ray> rays;
    std::string csv = "ray,who,t,u,v,triangle\n"; // the ray's place in the file of rays, from 0
    for (const DisputedRay& disputed : dispute.rays) {
        for (const auto& [who, hit] : disputed.answers) {
            csv += csv_line(rays.size(), who, hit.t, hit.u, hit.v, hit.triangle);
        }
        const ReferenceHit& truth = disputed.truth;
        csv += csv_line(rays.size(), "exact arithmetic", truth.t, truth.u, truth.v, truth.triangle);
        rays.push_back(disputed.ray);
    }
    const std::string name = "disputed_" + dispute.kind;
    const std::vector<std::filesystem::path> paths{folder / (name + "_rays.csv"),
                                                   folder / (name + "_answers.csv")};
    write_ray_file(paths[0], rays);
    write_file(paths[1], csv);
    return paths;
}

} // namespace raysteps
