// The numbers of a kernel that computes in double precision, in the place of real/float.glsl. Rays,
// triangles and hits stay floats in their textures. No part of the slot <real>: passes that shade
// hand their numbers on as floats.
#define real double
#define real3 dvec3
#define real4 dvec4

// 2^27 + 1, and 2^-900 (see real/float.glsl).
const real split_factor = 134217729.0lf;
const real least_product = 1.1830521861667747e-271lf;
