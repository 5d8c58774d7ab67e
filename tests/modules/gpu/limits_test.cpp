#include "catch.h"
#include "gpu/context.h"
#include "gpu/limits.h"

using namespace raysteps;

TEST_CASE("the limits of this machine suffice for every chapter", "[gpu][limits]") {
    const auto context = make_context(ContextKind::automatic);
    const Limits limits = measure_limits();
    CHECK(limits.loop_budget >= 1024); // below, measure_limits refuses
    CHECK(limits.loop_budget <= no_loop_limit);
    // OpenGL 4.1 promises these: its specification, tables 6.60 and 6.61.
    CHECK(limits.texture_size >= 16384);
    CHECK(most_buffer_texels() >= 65536);
}

TEST_CASE("the limits are the same when measured again", "[gpu][limits]") {
    const auto context = make_context(ContextKind::automatic);
    const Limits first = measure_limits();
    const Limits second = measure_limits();
    CHECK(first.loop_budget == second.loop_budget);
    CHECK(first.texture_size == second.texture_size);
}
