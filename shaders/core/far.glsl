// The t_max of a ray without an end: the largest single-precision number, so that no kernel depends
// on a platform's infinity.
const float farthest = 3.402823466e+38f;
