#pragma once

#include "question.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// Four numbers as bits; what they are is the checkpoint's own affair.
using Found = std::array<std::uint32_t, 4>;

// What was asked, and for each step what each of the rays found. Where the rays of a picture are
// the answer, there are none that were asked: step 1 has origin and t_min, step 2 direction and
// t_max. A picture lies in a file.
struct Answer {
    std::vector<Ray> rays;
    std::vector<std::vector<Found>> steps;
};

// Writes the answers to the questions of the job: for the programs course_builders and
// course_shaders, which take the names of the two files as their arguments. The exit code; where it
// is not 0, a sentence on standard error says why.
int answer_job(int argc, char** argv, const std::function<Answer(const Question&)>& answer);

// As {"answers": [{"rays": [...], "steps": [...]}, ...]}, in integers. Throws InputError where the
// file cannot be written.
void write_answers(const std::filesystem::path& file, std::span<const Answer> answers);

} // namespace raysteps
