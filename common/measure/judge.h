#pragma once

#include "basics/error.h"
#include "measure/ray_kinds.h"
#include "reference/exact.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// What one contender answered to rays of a kind: to all of them, or to a part.
struct Answers {
    std::string contender;
    std::vector<std::size_t> rays; // their numbers among all of the kind, ascending
    std::vector<Hit> hits;         // one for each of them
};

// Closest hits are the same where every bit is; of any hit, only whether there is one is compared,
// and a miss is a miss.
bool is_same_answer(const Hit& a, const Hit& b, Query query);

// The loop over every triangle, which needs no structure: the judge of those that have one.
using LoopOverTriangles = std::function<std::vector<Hit>(const RayKind& rays)>;
inline const std::string the_loop = "the loop over every triangle";

// Who differs from whom, and in how many of the rays that both were asked.
struct Disagreement {
    std::string one;
    std::string other;
    std::size_t rays = 0;
    std::size_t of = 0;
};

// A ray with more than one answer.
struct DisputedRay {
    std::size_t number = 0; // among all of the kind
    Ray ray;
    std::vector<std::pair<std::string, Hit>> answers; // of everyone who was asked
    ReferenceHit truth;                               // by exact arithmetic
};

// What a scene's rays of one kind are disputed about.
struct Dispute {
    std::string scene;
    std::string kind;
    std::size_t all_rays = 0;                // of that kind
    std::vector<Disagreement> disagreements; // the loop's first
    std::size_t disputed = 0;                // rays
    std::vector<DisputedRay> rays;           // the first most_disputed_rays of them
};

inline constexpr std::size_t most_disputed_rays = 4096;

// How many of its rays the loop traced too, for each contender; and what is disputed, if anything.
struct Judgement {
    std::vector<std::size_t> judged;
    std::optional<Dispute> dispute;
};

// Compares all contenders with each other on all rays that both were asked, and with the loop on
// every ray that they differ in (up to most_disputed_rays) and on a random sample (seed 7): of each
// contender's rays 1024, or as many as make 2^25 tests of a triangle, whichever is less.
Judgement judge(const Scene& scene, const RayKind& kind, std::span<const Answers> answers,
                const LoopOverTriangles& loop);

// Ends a program with exit code 1: a walk is wrong, or the triangle test is not exact.
class DisputeError : public Error {
public:
    explicit DisputeError(Dispute dispute);

    const Dispute& dispute() const { return dispute_; }

private:
    Dispute dispute_;
};

// For people: who differs from whom.
std::string to_table(const Dispute& dispute);

// Writes the disputed rays as a file of rays (docs/ray_files.md), and beside it who answered what:
// NAME_rays.csv and NAME_answers.csv in the folder. Returns their paths. Throws InputError.
std::vector<std::filesystem::path> write_dispute(const std::filesystem::path& folder,
                                                 const Dispute& dispute);

} // namespace raysteps
