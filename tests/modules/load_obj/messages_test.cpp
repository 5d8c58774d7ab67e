#include "model_folder.h"

#include "scene/obj/load_obj.h"

#include "catch.h"

using namespace raysteps;

namespace {

struct Loaded {
    int triangles = 0;
    std::string messages;
};

Loaded load_with_messages(const std::string& name) {
    const Scene scene = load_obj(corpus_file(name));
    return {triangle_count(scene), joined(scene.messages)};
}

} // namespace

TEST_CASE("faces with fewer than three different corners are dropped and counted by line",
          "[obj]") {
    const Loaded loaded = load_with_messages("zero_area.obj");
    CHECK(loaded.triangles == 2);
    CHECK_THAT(loaded.messages,
               contains_text("zero_area.obj:8: A face with fewer than three different corners was "
                             "dropped, 2 times (lines 8, 9)."));
}

TEST_CASE("a face whose corners lie on one line is kept and said", "[obj]") {
    CHECK_THAT(load_with_messages("zero_area.obj").messages,
               contains_text("zero_area.obj:6: A face has a triangle whose corners lie on one "
                             "line; it is kept, since it may close a slit."));
}

TEST_CASE("a face that repeats a vertex is dropped or drawn without the repetition", "[obj]") {
    const Loaded loaded = load_with_messages("repeated_index.obj");
    CHECK(loaded.triangles == 2);
    CHECK_THAT(loaded.messages,
               contains_text("A face with fewer than three different corners was dropped, 2 times "
                             "(lines 5, 8)."));
    CHECK_THAT(loaded.messages, contains_text("repeated_index.obj:6: A face names a vertex twice "
                                              "in a row; it is drawn as if once, 2 times "
                                              "(lines 6, 7)."));
}

TEST_CASE("faces with fewer than three corners are dropped and counted by line", "[obj]") {
    const Loaded loaded = load_with_messages("two_corners.obj");
    CHECK(loaded.triangles == 0);
    CHECK_THAT(loaded.messages, contains_text("two_corners.obj:4: A face with fewer than three "
                                              "corners was dropped, 3 times (lines 4, 5, 6)."));
}

TEST_CASE("normals that a file names and does not have are left out and counted", "[obj]") {
    const Scene scene =
        parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//2 3//3\nf 3 2 1\n", "n.obj");
    CHECK(triangle_count(scene) == 2);
    CHECK(scene.normals[0] == glm::vec3(0, 0, 1));
    CHECK_THAT(
        joined(scene.messages),
        contains_text("n.obj:4: A face names normals, but the file has none, so they are left "
                      "out."));
}

TEST_CASE("words that OBJ does not know are skipped and counted by line", "[obj]") {
    const Loaded capital = load_with_messages("upper_case.obj");
    CHECK(capital.triangles == 0);
    CHECK_THAT(capital.messages, contains_text("upper_case.obj:1: OBJ has no statement \"V\""));
    CHECK_THAT(capital.messages, contains_text("upper_case.obj:5: OBJ has no statement \"F\""));
    CHECK_THAT(capital.messages, contains_text("2 times (lines 5, 6)."));

    const Loaded unknown = load_with_messages("unknown_words.obj");
    CHECK(unknown.triangles == 1);
    CHECK_THAT(unknown.messages, contains_text("unknown_words.obj:4: OBJ has no statement "
                                               "\"zap\""));
}

TEST_CASE("lines and points and curves and groups are skipped in silence", "[obj]") {
    const Loaded loaded = load_with_messages("lines_and_curves.obj");
    CHECK(loaded.triangles == 1);
    CHECK_THAT(loaded.messages, !contains_text("no statement"));
}

TEST_CASE("however much is wrong the messages stay few", "[obj]") {
    std::string text;
    for (int i = 0; i < 10000; ++i)
        text += "word" + std::to_string(i) + " 1\nf 1\n";
    const Scene scene = parse_obj(text, "many.obj");
    CHECK(scene.messages.size() < 60);
    CHECK_THAT(joined(scene.messages),
               contains_text("many.obj:99: There is more of other kinds, 9951 times (lines 99, "
                             "101, 103, 105, 107, ...)."));
}

TEST_CASE("a smoothing group that is none sets smoothing off with a message", "[obj]") {
    const Loaded loaded = load_with_messages("smoothing_unknown.obj");
    CHECK(loaded.triangles == 4);
    CHECK_THAT(loaded.messages, contains_text(":6: There is no smoothing group \"-4\""));
    CHECK_THAT(loaded.messages, contains_text(":8: There is no smoothing group \"99999999999\""));
}
