#pragma once

// Products with a sum, compiled for the processor at hand with all that it offers, so that a
// compiler that may fuse the two does so.
float multiply_add(float a, float b, float c);
double multiply_add(double a, double b, double c);

// Whether that processor has an instruction that fuses.
bool processor_fuses();
