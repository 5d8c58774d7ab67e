// The numbers of every kernel: single precision, as graphics hardware has it.
#define real float
#define real3 vec3
