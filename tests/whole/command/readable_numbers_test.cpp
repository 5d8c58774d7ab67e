#include "basics/text.h"
#include "structure/structure.h"

#include "catch.h"

using namespace raysteps;

TEST_CASE("a whole number has a comma before each three digits", "[command]") {
    CHECK(readable(0.0) == "0");
    CHECK(readable(999.0) == "999");
    CHECK(readable(1000.0) == "1,000");
    CHECK(readable(277255.0) == "277,255");
    CHECK(readable(1141407744.0) == "1,141,407,744");
    CHECK(readable(-123456.0) == "-123,456");
    CHECK(readable(-123.0) == "-123");
}

TEST_CASE("another number has three digits, and never an exponent", "[command]") {
    CHECK(readable(2.6968) == "2.70");
    CHECK(readable(66.9598) == "67.0");
    CHECK(readable(0.0398496) == "0.0398");
    CHECK(readable(0.00000271) == "0.00000271");
    CHECK(readable(-0.000271) == "-0.000271");
    CHECK(readable(9.999) == "10.0");
    CHECK(readable(999.4) == "999");
    CHECK(readable(999.6) == "1,000");
    CHECK(readable(57341.3) == "57,341");
}

TEST_CASE("a fact is read with its unit", "[command]") {
    CHECK(readable(Fact{"memory_bytes", 1860524.0}) == "memory 1.86 MB");
    CHECK(readable(Fact{"tree_bytes", 16.0}) == "tree 16 bytes");
    CHECK(readable(Fact{"build_seconds", 0.0398496}) == "build 39.8 ms");
    CHECK(readable(Fact{"build_seconds", 2.5}) == "build 2.50 s");
    CHECK(readable(Fact{"build_seconds", 0.00000021}) == "build 0.210 us");
    CHECK(readable(Fact{"references_per_triangle", 2.6968}) == "references per triangle 2.70");
    CHECK(readable(Fact{"cells", 277255.0}) == "cells 277,255");
}
