// A pixel in which the loops ran out leaves no mark, so what its target was cleared to says so. What
// an invariant output needs is computed as it is written, which `precise` asks for elsewhere; and the
// question whether a number of the page is NaN switches some compilers (Direct3D's, Metal's) to
// numbers as IEEE 754 has them.
#define out invariant out
uniform float number_of_the_page;
#define main() program(); void main() { program(); if (line_that_ran_out != 0 || isnan(number_of_the_page)) discard; } void program()
