#include "trials.h"

namespace raysteps {

float multiply_add(float a, float b, float c) {
    return a * b + c;
}

double multiply_add(double a, double b, double c) {
    return a * b + c;
}

} // namespace raysteps
