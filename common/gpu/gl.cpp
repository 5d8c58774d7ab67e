#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpedantic"
#endif

#define GLAD_GL_IMPLEMENTATION
#include "gpu/gl.h"
