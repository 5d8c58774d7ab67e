// What every program of the sanitize preset tells the sanitizers, however it is started: by CTest,
// by hand, or by ./course with an environment of its own.

extern "C" {

// clang++ 14 takes memory that libraries keep for each thread to be where it is not (glibc 2.36),
// and LeakSanitizer ends with a fault of its own.
const char* __asan_default_options() {
    return "detect_stack_use_after_return=1:intercept_tls_get_addr=0";
}

const char* __ubsan_default_options() {
    return "print_stacktrace=1";
}

const char* __lsan_default_options() {
    return "print_suppressions=0";
}

// Memory that graphics drivers and window systems keep to the end of the process, which is not ours
// to free.
const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\n"
           "leak:libgallium\n"
           "leak:swrast_dri\n"
           "leak:libLLVM\n"
           "leak:libglapi\n"
           "leak:libEGL\n"
           "leak:libGLX\n"
           "leak:libX11\n"
           "leak:libglfw\n"
           "leak:libembree\n"
           "leak:libtbb\n";
}

// Libraries stay loaded: of one that is gone when the leaks are counted, a driver's for example,
// nobody can tell any more whose they are.
int dlclose(void*) {
    return 0;
}
}
