#pragma once

namespace raysteps {

// a * b + c, in a file of its own, so that the compiler cannot know the numbers.
float multiply_add(float a, float b, float c);
double multiply_add(double a, double b, double c);

} // namespace raysteps
