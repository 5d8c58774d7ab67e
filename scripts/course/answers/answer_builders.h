#pragma once

#include "answer.h"

namespace raysteps {

// Answers by the builders that the program is linked with. The rays of the question are boxes here:
// the origin is the lower corner, the direction the upper one; random ones lie in the cube from -1
// to 1. Step k is the answer for the first `numbers.least + k - 1` of them, with one entry (least
// is 2 where it is not named). Throws InputError where the subject is none of the known.
Answer answer_by_builders(const CourseQuestion& question);

} // namespace raysteps
