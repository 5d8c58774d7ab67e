#pragma once

#include "question.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace raysteps {

// Numbers as bits. What the first eight are is the checkpoint's own affair; of a shader part, the
// last four say what was observed (shaders/observer_in_order.glsl).
using Found = std::array<std::uint32_t, 12>;

// What was asked, and for each step what each of the rays found. Where the rays of a picture are
// the answer, there are none that were asked: step 1 has origin and t_min, step 2 direction and
// t_max. Of a walk, step 1 has what was observed, one after the other: 1 for a visit, 2 for a test,
// 0 where there is nothing more; the place or triangle; the round; whether the walk has ended by
// then. Step 2 has the nearest hit after that round, step 3 the place. A picture lies in a file.
struct Answer {
    std::vector<Ray> rays;
    std::vector<std::vector<Found>> steps;
};

using AnswerQuestion = std::function<Answer(const CourseQuestion&)>;

// Writes the answers to the questions of the job: for the programs course_builders and
// course_shaders, which take the names of the two files as their arguments. The exit code; where it
// is not 0, a sentence on standard error says why. An answer is {"rays": [...], "steps": [...]}, in
// integers.
int answer_job(int argc, char** argv, const AnswerQuestion& answer);

// Answers a job in each line of standard input with a line of standard output, until there are no
// more. A line is a job with its own folders of shaders: {"shaders": "FOLDER:FOLDER", "questions":
// [...]}. Its reply is {"answers": [...]}, or {"code": 3, "message": ...} with the exit code and
// the sentence of a job that has no answer.
void answer_jobs(const AnswerQuestion& answer);

} // namespace raysteps
