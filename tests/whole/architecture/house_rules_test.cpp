#include "catch.h"
#include "rules.h"
#include "small_tree.h"
#include "source_tree.h"

// What keeps the house small. A limit is lowered where it can be, and raised by nobody.

TEST_CASE("a header that one file includes is found", "[architecture]") {
    const SmallTree tree("headers_of_one_file");
    tree.write("common/scene/a.h", "");
    tree.write("common/scene/a.cpp", "#include \"scene/a.h\"\n#include \"scene/b.h\"\n");
    tree.write("common/scene/b.h", "");
    tree.write("common/scene/c.h", "#include \"scene/a.h\"\n");
    tree.write("chapters/01_rays/main.cpp", "#include \"scene/a.h\"\n#include \"scene/c.h\"\n");
    tree.write("tests/scene/c_test.cpp", "#include \"scene/c.h\"\n");
    CHECK(join_lines(list_headers_of_one_file(tree.root())) ==
          "common/scene/b.h is for common/scene/a.cpp alone.\n"
          "common/scene/c.h is for chapters/01_rays/main.cpp alone.\n");
}

TEST_CASE("a source sees a package through headers", "[architecture]") {
    const SmallTree tree("seen_packages");
    tree.write("common/program/options.h", "#include <CLI/CLI.hpp>\n");
    tree.write("common/program/show.h", "#include \"program/options.h\"\n");
    tree.write("common/program/show.cpp", "#include \"program/show.h\"\n");
    tree.write("common/program/help.cpp", "#include <string>\n");
    CHECK(join_lines(list_sources_that_see(tree.root(), "CLI/CLI.hpp")) ==
          "common/program/show.cpp\n");
}

TEST_CASE("a name that is defined twice in a namespace is found", "[architecture]") {
    const SmallTree tree("double_names");
    tree.write("common/scene/a.h",
               "namespace raysteps {\n\nstruct Findings {\n    int a;\n};\n\n"
               "struct Later;\n\ninline int first(int a) {\n    return a;\n}\n\n"
               "} // namespace raysteps\n");
    tree.write("tests/scene/b.h", "namespace raysteps {\n\nclass Findings {};\n\n"
                                  "inline int first(double a) {\n    return 1;\n}\n\n"
                                  "inline int\nfirst(int a) {\n    return a;\n}\n\n"
                                  "} // namespace raysteps\n\nnamespace other {\n\n"
                                  "struct Findings {};\n\n} // namespace other\n\n"
                                  "struct Later {};\n");
    tree.write("tests/scene/b_test.cpp",
               "namespace raysteps {\nnamespace {\n\nstruct Findings {};\n\n"
               "} // namespace\n} // namespace raysteps\n");
    CHECK(join_lines(find_double_names(tree.root())) ==
          "tests/scene/b.h:3: raysteps::Findings is defined in common/scene/a.h:3 too.\n"
          "tests/scene/b.h:9: raysteps::first(int a) is defined in common/scene/a.h:9 too.\n");
}

TEST_CASE("tests in a file that is not named as one are found", "[architecture]") {
    const SmallTree tree("misnamed_tests");
    tree.write("tests/scene/a_test.cpp", "TEST_CASE(\"a\") {}\n");
    tree.write("tests/scene/b.cpp", "TEST_CASE(\"b\") {}\n");
    tree.write("tests/scene/c_test.cpp", "int c;\n");
    CHECK(join_lines(find_misnamed_tests(tree.root())) ==
          "tests/scene/b.cpp: has tests, so its name ends in _test.cpp.\n"
          "tests/scene/c_test.cpp: has no test, so its name does not say so.\n");
}

TEST_CASE("common has at most 12 modules", "[architecture]") {
    const std::vector<std::string> modules = list_targets(RAYSTEPS_SOURCE_DIR, "common");
    CAPTURE(modules);
    CHECK(modules.size() >= 10);
    CHECK(modules.size() <= 12);
}

TEST_CASE("few headers of common are there for one file", "[architecture]") {
    constexpr std::size_t most_headers_of_one_file = 20;
    const std::vector<std::string> headers = list_headers_of_one_file(RAYSTEPS_SOURCE_DIR);
    CAPTURE(join_lines(headers));
    CHECK(headers.size() <= most_headers_of_one_file);
}

TEST_CASE("few sources wait for the slowest headers", "[architecture]") {
    constexpr std::size_t most_sources_that_see_options = 2;
    constexpr std::size_t most_sources_that_see_json = 6;
    const auto options = list_sources_that_see(RAYSTEPS_SOURCE_DIR, "CLI/CLI.hpp");
    const auto json = list_sources_that_see(RAYSTEPS_SOURCE_DIR, "nlohmann/json.hpp");
    CAPTURE(join_lines(options), join_lines(json));
    CHECK(options.size() <= most_sources_that_see_options);
    CHECK(json.size() <= most_sources_that_see_json);
}

TEST_CASE("every type and inline function has its name for itself", "[architecture]") {
    CHECK(find_double_names(RAYSTEPS_SOURCE_DIR) == no_faults);
}

TEST_CASE("every file with tests is named as one", "[architecture]") {
    CHECK(find_misnamed_tests(RAYSTEPS_SOURCE_DIR) == no_faults);
}
