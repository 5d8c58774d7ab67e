#include "manifests.h"

#include "catch.h"
#include "small_tree.h"
#include "source_tree.h"

TEST_CASE("a file that is born twice or never or does not exist is found", "[architecture]") {
    const SmallTree tree("manifests");
    tree.write("chapters/01_a/CMakeLists.txt",
               "add_chapter(01_a USES scene\n  BORN\n    common/scene # all of it\n    lost.h)\n");
    tree.write("chapters/02_b/CMakeLists.txt", "add_chapter(02_b BORN common/scene/b.h)\n");
    tree.write("chapters/03_c/CMakeLists.txt", "add_chapter(03_c BORN common/scene/b.h)\n");
    tree.write("common/scene/a.h", "");
    tree.write("common/scene/b.h", "");
    tree.write("shaders/orphan.glsl", "");
    CHECK(join_lines(find_faults_of_manifests(tree.root())) ==
          "chapters/01_a/CMakeLists.txt: BORN names lost.h, which does not exist.\n"
          "common/scene/b.h: is born in 02_b and 03_c.\n"
          "shaders/orphan.glsl: is born in no chapter.\n");
}

TEST_CASE("a file that names one of a later chapter is found", "[architecture]") {
    const SmallTree tree("unborn");
    tree.write("chapters/01_a/CMakeLists.txt", "add_chapter(01_a BORN common shaders)\n");
    tree.write("chapters/02_b/CMakeLists.txt",
               "add_chapter(02_b BORN common/scene/b.cpp shaders/pass/b.frag)\n");
    tree.write("common/scene/b.cpp", "Program program(\"pass/b.frag\");\n");
    tree.write("common/scene/a.cpp", "// \"pass/b.frag\"\nProgram program(\"pass/b.frag\");\n");
    tree.write("shaders/pass/b.frag", "");
    CHECK(join_lines(find_names_of_the_unborn(tree.root())) ==
          "common/scene/a.cpp:2: is born in 01_a and names shaders/pass/b.frag, which is born in "
          "02_b.\n");
}

TEST_CASE("what the visualizer brings is born there and unknown to chapters", "[architecture]") {
    const SmallTree tree("visualizer_manifest");
    tree.write("chapters/01_a/CMakeLists.txt", "add_chapter(01_a BORN common)\n");
    tree.write("visualizer/CMakeLists.txt", "add_visualizer(USES scene BORN common/replay lost)\n");
    tree.write("common/replay/step.h", "");
    tree.write("common/a.cpp", "#include \"replay/step.h\"\n");
    CHECK(join_lines(find_faults_of_manifests(tree.root())) ==
          "visualizer/CMakeLists.txt: BORN names lost, which does not exist.\n");
    CHECK(join_lines(find_names_of_the_unborn(tree.root())) ==
          "common/a.cpp:1: is born in 01_a and names common/replay/step.h, which is born in "
          "visualizer.\n");
}

TEST_CASE("a program without a number names every chapter and is named by every chapter",
          "[architecture]") {
    const SmallTree tree("unnumbered");
    tree.write("chapters/01_a/CMakeLists.txt", "add_chapter(01_a BORN common/scene/a.h)\n");
    tree.write("chapters/program/CMakeLists.txt", "add_chapter(program BORN common/scene/p.h)\n");
    tree.write("common/scene/a.h", "#include \"scene/p.h\"\n");
    tree.write("common/scene/p.h", "#include \"scene/a.h\"\n");
    CHECK(find_names_of_the_unborn(tree.root()) == no_faults);
}

TEST_CASE("every file is born in one chapter", "[architecture]") {
    REQUIRE(list_files(RAYSTEPS_SOURCE_DIR, {"common", "shaders"}).size() >= 200);
    CHECK(find_faults_of_manifests(RAYSTEPS_SOURCE_DIR) == no_faults);
}

TEST_CASE("no file names one of a later chapter", "[architecture]") {
    CHECK(find_names_of_the_unborn(RAYSTEPS_SOURCE_DIR) == no_faults);
}
