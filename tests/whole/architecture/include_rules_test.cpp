#include "catch.h"
#include "rules.h"
#include "small_tree.h"
#include "source_tree.h"

// Known answers: a tree of a few files with one fault each.

TEST_CASE("an include of a module that USES does not name is found", "[architecture]") {
    const SmallTree tree("undeclared_use");
    tree.write("common/scene/CMakeLists.txt", "add_module(scene USES basics)\n");
    tree.write("common/basics/box.h", "#pragma once\n");
    tree.write("common/gpu/draw.h", "#pragma once\n");
    tree.write("common/scene/scene.cpp",
               "#include \"basics/box.h\"\n// #include \"gpu/draw.h\"\n#include \"gpu/draw.h\"\n");
    CHECK(join_lines(find_undeclared_uses(tree.root())) ==
          "common/scene/scene.cpp:3: scene includes gpu, but its add_module does not name it in "
          "USES.\n");
}

TEST_CASE("a use that no file includes is found", "[architecture]") {
    const SmallTree tree("dead_use");
    tree.write("common/scene/CMakeLists.txt",
               "# USES gpu\nadd_module(scene\n  USES basics gpu\n  PACKAGES glm::glm)\n");
    tree.write("common/basics/box.h", "#pragma once\n");
    tree.write("common/gpu/draw.h", "#pragma once\n");
    tree.write("common/scene/scene.cpp", "#include \"basics/box.h\"\n");
    CHECK(join_lines(find_dead_uses(tree.root())) ==
          "common/scene/CMakeLists.txt: USES names gpu, which no file of scene includes.\n");
}

TEST_CASE("an include against the arrow is found", "[architecture]") {
    const SmallTree tree("arrow");
    tree.write("tests/catch.h", "#include <string>\n");
    tree.write("shaders/core/ray.glsl", "struct Ray {};\n");
    tree.write("common/scene/scene.h",
               "#include \"catch.h\"\n#include \"core/ray.glsl\"\n#include \"vector\"\n");
    tree.write("common/mirror/mirror.h", "#include \"core/ray.glsl\"\n");
    tree.write("chapters/01_rays/rays.h", "#include \"scene/scene.h\"\n");
    tree.write("chapters/02_triangles/main.cpp", "#include \"01_rays/rays.h\"\n");
    CHECK(join_lines(find_includes_against_the_arrow(tree.root())) ==
          "chapters/02_triangles/main.cpp:1: includes chapters/01_rays/rays.h: a chapter includes "
          "nothing of another.\n"
          "common/scene/scene.h:1: includes tests/catch.h: nothing includes tests/ but tests/ "
          "itself and tests.\n"
          "common/scene/scene.h:2: includes shaders/core/ray.glsl: shaders are C++ only in "
          "common/basics, structure and mirror.\n"
          "common/scene/scene.h:3: \"vector\" is no file of ours. Name packages as <...>.\n");
}

TEST_CASE("a package outside of its place is found", "[architecture]") {
    const SmallTree tree("packages");
    tree.write("common/gpu/gl.h", "#include <glad/gl.h>\n");
    tree.write("common/render/pass.cpp", "#include <vector>\n#include <glad/gl.h>\n");
    CHECK(join_lines(find_scattered_packages(tree.root())) ==
          "common/render/pass.cpp:2: <glad/gl.h> is for common/gpu/gl.h to include.\n");
}

TEST_CASE("a use that the table of modules does not allow is found", "[architecture]") {
    const SmallTree tree("module_table");
    tree.write("docs/architecture.md", "| module | what it is | may include |\n"
                                       "| common/scene | scenes | basics, image; never gpu |\n"
                                       "| common/lost | gone | nothing |\n"
                                       "| chapters | compose | common |\n");
    tree.write("common/scene/CMakeLists.txt", "add_module(scene USES basics gpu)\n");
    tree.write("common/new/CMakeLists.txt", "add_module(new)\n");
    CHECK(join_lines(find_uses_beyond_the_table(tree.root())) ==
          "docs/architecture.md: the table of modules has no row common/new.\n"
          "common/scene/CMakeLists.txt: USES names gpu, which the table of docs/architecture.md "
          "does not allow.\n"
          "docs/architecture.md: there is no common/lost.\n");
}

TEST_CASE("every module includes only what its USES names", "[architecture]") {
    REQUIRE(list_targets(RAYSTEPS_SOURCE_DIR, "common").size() >= 11);
    CHECK(find_undeclared_uses(RAYSTEPS_SOURCE_DIR) == no_faults);
}

TEST_CASE("every module links only what the table of modules allows", "[architecture]") {
    CHECK(find_uses_beyond_the_table(RAYSTEPS_SOURCE_DIR) == no_faults);
}

TEST_CASE("every module includes all that its USES names", "[architecture]") {
    CHECK(find_dead_uses(RAYSTEPS_SOURCE_DIR) == no_faults);
}

TEST_CASE("includes follow the arrow from shaders over common to chapters and tests",
          "[architecture]") {
    CHECK(find_includes_against_the_arrow(RAYSTEPS_SOURCE_DIR) == no_faults);
}

TEST_CASE("every package is known in one place", "[architecture]") {
    CHECK(find_scattered_packages(RAYSTEPS_SOURCE_DIR) == no_faults);
}
