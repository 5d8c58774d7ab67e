#include "catch.h"
#include "scene/load_scene.h"
#include "scene/ray_file.h"
#include "support/same_bits.h"
#include "support/scratch_folder.h"

#include <algorithm>
#include <array>

using namespace raysteps;

namespace {

constexpr const char* two_objects = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                    "o plate\nf 1 2 3 4\n" // two triangles
                                    "f 1 1 2\n"            // dropped: two different corners
                                    "f 1 2\n"              // dropped: two corners
                                    "o wedge\ng left\nf 1 2 4\no plate\nf 2 3 4\n";

} // namespace

TEST_CASE("a triangle keeps the names of its file whatever was split or dropped",
          "[scene][names]") {
    const ScratchFolder folder("names");
    put_bytes(folder / "two.obj", two_objects);
    const Scene scene = load_scene((folder / "two.obj").string(), 1.0f);
    REQUIRE(triangle_count(scene) == 4);
    CHECK(name_of_triangle(scene, 0) == "two.obj, object \"plate\", face 1");
    CHECK(name_of_triangle(scene, 1) == "two.obj, object \"plate\", face 1");
    CHECK(name_of_triangle(scene, 2) == "two.obj, object \"wedge\", face 4");
    CHECK(name_of_triangle(scene, 3) == "two.obj, object \"plate\", face 5");
    CHECK(name_of_triangle(scene, 4).empty());
    CHECK(name_of_triangle(scene, no_triangle).empty());
    CHECK(describe_runs(scene) ==
          std::vector<std::string>{"triangles 0 to 1: two.obj, object \"plate\", face 1",
                                   "triangle 2: two.obj, object \"wedge\", face 4",
                                   "triangle 3: two.obj, object \"plate\", face 5"});
    CHECK_THAT(to_toml(scene),
               contains_text("\n# triangle 2: two.obj, object \"wedge\", face 4\n"));
}

TEST_CASE("a group names its triangles where there are no objects", "[scene][names]") {
    const ScratchFolder folder("groups");
    put_bytes(folder / "g.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\ng ear\nf 3 2 1\n");
    const Scene scene = load_scene((folder / "g.obj").string(), 1.0f);
    CHECK(name_of_triangle(scene, 0) == "g.obj, face 1");
    CHECK(name_of_triangle(scene, 1) == "g.obj, object \"ear\", face 2");
}

TEST_CASE("models of a scene file keep their own names and face numbers", "[scene][names]") {
    const ScratchFolder folder("names_of_two");
    put_bytes(folder / "two.obj", two_objects);
    const Scene scene =
        read_toml_scene("[[model]]\npath = \"two.obj\"\n[[model]]\npath = \"two.obj\"\n"
                        "translate = [3, 0, 0]\n",
                        folder / "both.toml", 1.0f);
    REQUIRE(triangle_count(scene) == 8);
    CHECK(name_of_triangle(scene, 7) == name_of_triangle(scene, 3));
    CHECK(scene.runs.back().model == 1);
}

TEST_CASE("hits in a table name what they hit and samples have no names", "[scene][names]") {
    const ScratchFolder folder("named_hits");
    put_bytes(folder / "two.obj", two_objects);
    const Scene scene = load_scene((folder / "two.obj").string(), 1.0f);
    const std::array hits{Hit{1.5f, 0.25f, 0.5f, 2}, Hit{9.0f, 0.0f, 0.0f, no_triangle}};
    write_hit_file(folder / "hits.csv", hits, scene);
    CHECK(bytes_of(folder / "hits.csv") ==
          "t,u,v,triangle,name\n1.5,0.25,0.5,2,\"two.obj, object \"\"wedge\"\", face 4\"\n"
          "9,0,0,-1,\n");
    const std::vector<Hit> again = read_hit_file(folder / "hits.csv");
    CHECK(std::ranges::equal(again, hits,
                             [](const Hit& a, const Hit& b) { return same_bits(a, b); }));
    write_hit_file(folder / "hits.csv", hits, load_scene("compact:1", 1.0f));
    CHECK(bytes_of(folder / "hits.csv") == "t,u,v,triangle\n1.5,0.25,0.5,2\n9,0,0,-1\n");
}
