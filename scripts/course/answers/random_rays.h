#pragma once

#include "question.h"

#include "basics/box.h"

#include <vector>

namespace raysteps {

// The random rays of a question, from around the box to a point in it, so that most meet something.
// Ray i is of family i % the number of families. Throws InputError where a family is none of the
// known.
std::vector<Ray> random_rays(const CourseQuestion& question, const Box& box);

} // namespace raysteps
