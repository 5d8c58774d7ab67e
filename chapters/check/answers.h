#pragma once

#include "inspection.h"

#include "basics/ray.h"
#include "measure/judge.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// A ray that got another answer than the judge's.
struct WrongAnswer {
    std::size_t ray = 0;
    Hit given{};
    Hit right{};
    std::string cause{};
    bool is_fault = true; // else it slips through a tight box, by rounding
};

// Answers to rays, compared with those of our own tree, which the loop over every triangle and
// exact arithmetic confirm (measure/judge.h).
struct AnswerCheck {
    std::size_t rays = 0;
    std::size_t judged = 0;      // by the loop, of a random sample
    std::size_t by_rounding = 0; // others that rounding explains: of hits from elsewhere
    std::vector<WrongAnswer> wrong{};
};

// What walks through the tree find. Throws InputError where none goes through it, and DisputeError
// where our own tree is wrong.
AnswerCheck check_walks(const AnyTree& tree, const Scene& scene, std::span<const Ray> rays);

// What somebody found, by whatever means: a hit for each ray. Of two triangles that are equally
// near within the padding of our structures, either is right; so is either answer where a ray meets
// an edge within rounding.
AnswerCheck check_hits(std::span<const Hit> hits, const Scene& scene, std::span<const Ray> rays);

std::size_t count_faults(const AnswerCheck& check);

std::string to_table(const AnswerCheck& check);
Numbers numbers_of(const AnswerCheck& check);

} // namespace raysteps
