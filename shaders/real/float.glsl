// The numbers of every kernel: single precision, as graphics hardware has it.
#define real float
#define real3 vec3
#define real4 vec4

// Splits a number in two halves of 12 digits: 2^12 + 1 (triangle/watertight/exact_area.glsl).
const real split_factor = 4097.0f;

// 2^-76: a product that is greater has a missing part, a multiple of 2^-48 of it, that is no
// denormal.
const real least_product = 1.3234889800848443e-23f;
