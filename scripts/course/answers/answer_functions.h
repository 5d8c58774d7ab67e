#pragma once

#include "answer.h"

namespace raysteps {

// Answers by functions of a few numbers, in C++: the rays of the question are eight numbers each
// here, in the order of a ray's, and each has its own answer, in one step. Random numbers are over
// 0 and at most 4. Throws InputError where the subject is none of the known.
Answer answer_by_functions(const CourseQuestion& question);

} // namespace raysteps
