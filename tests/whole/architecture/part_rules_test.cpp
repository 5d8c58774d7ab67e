#include "catch.h"
#include "rules.h"
#include "small_tree.h"
#include "source_tree.h"

TEST_CASE("what breaks the contract of parts is found", "[architecture]") {
    const SmallTree tree("parts");
    tree.write("shaders/core/ray.glsl", "#include \"core/hit.glsl\"\n// gl_FragCoord.xy\n");
    tree.write("shaders/light/a.glsl", "layout (location = 0) vec4 a;\nfloat b = gl_FragCoord.x;\n"
                                       "void c(inout float d);\ninline float e();\n"
                                       "#version 410 core\nvec3 f = g.xyz;\nfloat h = g.x;\n");
    tree.write("shaders/view/b.glsl", "vec2 a = b.xy;\n");
    CHECK(join_lines(find_faults_of_parts(tree.root())) ==
          "shaders/core/ray.glsl:1: a part of core includes nothing.\n"
          "shaders/light/a.glsl:1: layout(...) is for passes.\n"
          "shaders/light/a.glsl:2: gl_* is for passes.\n"
          "shaders/light/a.glsl:3: no output parameters: return a struct.\n"
          "shaders/light/a.glsl:4: `inline` is no GLSL.\n"
          "shaders/light/a.glsl:5: #version is for passes.\n"
          "shaders/light/a.glsl:6: a swizzle is no C++. Write vec3(v), or name the components "
          "one by one.\n");
}

TEST_CASE("a pass without its version is found", "[architecture]") {
    const SmallTree tree("passes");
    tree.write("shaders/pass/a.frag", "// a\n#version 410 core\n");
    tree.write("shaders/view/b.vert", "#version 410 core\n");
    CHECK(join_lines(find_faults_of_passes(tree.root())) ==
          "shaders/pass/a.frag:1: a pass begins with `#version 410 core`.\n"
          "shaders/view/b.vert:1: passes are in shaders/pass.\n");
}

TEST_CASE("every part keeps the contract of one text for two compilers", "[architecture]") {
    REQUIRE(list_files(RAYSTEPS_SOURCE_DIR, {"shaders"}, {".glsl"}).size() >= 20);
    CHECK(find_faults_of_parts(RAYSTEPS_SOURCE_DIR) == no_faults);
}

TEST_CASE("every pass begins with its version", "[architecture]") {
    REQUIRE(list_files(RAYSTEPS_SOURCE_DIR, {"shaders"}, {".frag"}).size() >= 10);
    CHECK(find_faults_of_passes(RAYSTEPS_SOURCE_DIR) == no_faults);
}
