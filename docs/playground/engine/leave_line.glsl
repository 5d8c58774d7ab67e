// The line at which the loops of a pixel ran out, as a depth: so it needs no output of the pass.
#define out invariant out
#define main() program(); void main() { program(); gl_FragDepth = float(line_that_ran_out) / 16777216.0; } void program()
