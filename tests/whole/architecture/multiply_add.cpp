#include "multiply_add.h"

float multiply_add(float a, float b, float c) {
    return a * b + c;
}

double multiply_add(double a, double b, double c) {
    return a * b + c;
}

bool processor_fuses() {
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    return true;
#else
    return false;
#endif
}
