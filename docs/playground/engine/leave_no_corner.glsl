// A corner whose loops ran out lies with the others in one point, so nothing is drawn.
#define main() program(); void main() { program(); if (line_that_ran_out != 0) gl_Position = vec4(0.0); } void program()
