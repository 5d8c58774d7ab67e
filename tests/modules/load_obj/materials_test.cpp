#include "model_folder.h"

#include "scene/obj/load_obj.h"
#include "scene/obj/mtl.h"

#include "catch.h"

#include <sys/stat.h>

using namespace raysteps;

namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
constexpr const char* red = "newmtl red\nKd 1 0 0\n";

Material first_material(std::string_view text) {
    return parse_mtl(text, "test.mtl", ".").materials.at(0);
}

} // namespace

TEST_CASE("values that no material can have are corrected with file and line", "[mtl]") {
    const Scene scene = load_obj(corpus_file("bad_values.obj"));
    const Material& bad = scene.materials.at(0);
    CHECK(bad.refractive_index == 1.0f);
    CHECK(bad.diffuse == glm::vec3(0.0f, 0.5f, 1.0f));
    CHECK(bad.shininess == 1e6f);
    CHECK(bad.specular == Material{}.specular);
    CHECK(bad.opacity == 1.0f);
    CHECK(bad.illumination_model == Material{}.illumination_model);
    CHECK(bad.emission == Material{}.emission);
    CHECK(bad.transmission == Material{}.transmission);
    CHECK(bad.diffuse_map.empty());
    CHECK(scene.triangle_materials.at(0) == 0);

    const std::string messages = joined(scene.messages);
    for (
        const char* sentence :
        {"bad_values.mtl:1: A line before the first newmtl belongs to no material",
         "bad_values.mtl:3: In material \"bad\", Ni \"0\" is not a number between 0.001 and 10, so "
         "the line was left out.",
         "bad_values.mtl:4: In material \"bad\", Kd \"2\" is not a number between 0 and 1, so 1 is "
         "used.",
         "bad_values.mtl:5: In material \"bad\", Ns \"inf\" is not a number between 0 and 1e+06, "
         "so "
         "1e+06 is used.",
         "bad_values.mtl:6: In material \"bad\", Ks \"nan\" is not a number",
         "bad_values.mtl:7: In material \"bad\", d \"2\" is not a number between 0 and 1, so 1 is "
         "used.",
         "bad_values.mtl:8: In material \"bad\", illum \"99\" is not a number between 0 and 10",
         "bad_values.mtl:9: In material \"bad\", Ke \"\" is not a number",
         "bad_values.mtl:10: In material \"bad\", Tf \"spectral\" is not a number",
         "bad_values.mtl:11: MTL has no statement \"Kx\"",
         "bad_values.mtl: The texture \"../../secret.png\" is not in the folder of the model",
         "bad_values.mtl:13: newmtl gives no name",
         "bad_values.mtl:14: In material \"default\", Tr \"-1\" is not a number",
         "bad_values.mtl:15: Material \"bad\" is made twice, so the first one is used."})
        CHECK_THAT(messages, contains_text(sentence));
}

TEST_CASE("one value for a colour is a grey", "[mtl]") {
    CHECK(first_material("newmtl a\nKd 0.25\n").diffuse == glm::vec3(0.25f));
}

TEST_CASE("where a material gives both d and Tr the value of d counts", "[mtl]") {
    CHECK(first_material("newmtl a\nd 0.25\nTr 0.5\n").opacity == 0.25f);
    CHECK(first_material("newmtl a\nTr 0.5\nd 0.25\n").opacity == 0.25f);
    CHECK(first_material("newmtl a\nTr 0.25\n").opacity == 0.75f);
}

TEST_CASE("what an MTL file does not say is as in the default material", "[mtl]") {
    const Material material = first_material("newmtl a\n");
    const Material standard;
    CHECK(material.diffuse == standard.diffuse);
    CHECK(material.specular == standard.specular);
    CHECK(material.shininess == standard.shininess);
    CHECK(material.transmission == standard.transmission);
    CHECK(material.refractive_index == standard.refractive_index);
    CHECK(material.illumination_model == standard.illumination_model);
}

TEST_CASE("numbers of an MTL file keep every bit", "[mtl]") {
    CHECK(first_material("newmtl a\nKd 0.1 0.7 0.123456789\n").diffuse ==
          glm::vec3(0.1f, 0.7f, 0.123456789f));
    CHECK(first_material("newmtl a\nNi 1.5168\n").refractive_index == 1.5168f);
}

TEST_CASE("material files outside the folder of the model are not read", "[mtl]") {
    const std::string messages = joined(load_obj(corpus_file("library_outside.obj")).messages);
    CHECK_THAT(messages, contains_text("library_outside.obj:1: The material file "
                                       "\"../../dev/zero\" is not in the folder of the model"));
    CHECK_THAT(messages, contains_text("\"/dev/zero\" is not in the folder of the model"));
    // One of that name beside the model is another file.
    CHECK_THAT(messages, contains_text("\"..\\cube.mtl\" is not there, so \"cube.mtl\" was read"));
    CHECK_THAT(messages, contains_text("\"deeper/../../cube.mtl\" is not there, so \"cube.mtl\""));
}

TEST_CASE("material files and textures are found beside the model by their last word", "[mtl]") {
    const ModelFolder folder("found");
    folder.write("red.mtl", std::string(red) + "map_Kd C:\\work\\a.png\nmap_d pictures/b.png\n");
    folder.write("textures/a.png", "");
    const Scene scene =
        load_obj(folder.write("a.obj", std::string("mtllib scenes/red.mtl\n") + triangle));
    CHECK(scene.materials.at(0).diffuse == glm::vec3(1, 0, 0));
    CHECK(scene.materials.at(0).diffuse_map == (folder.path() / "textures/a.png").string());
    const std::string messages = joined(scene.messages);
    CHECK_THAT(messages, contains_text("\"scenes/red.mtl\" is not there, so \"red.mtl\" was read"));
    CHECK_THAT(messages, contains_text("There is no texture \"pictures/b.png\". Tried: " +
                                       (folder.path() / "pictures/b.png").string() + ", " +
                                       (folder.path() / "b.png").string() + ", " +
                                       (folder.path() / "textures/b.png").string() + "."));
}

TEST_CASE("the material file of the model's own name is found", "[mtl]") {
    const ModelFolder folder("own_name");
    folder.write("a.mtl", red);
    const Scene scene =
        load_obj(folder.write("a.obj", std::string("mtllib lost.mtl\n") + triangle));
    CHECK(scene.materials.at(0).name == "red");
    CHECK_THAT(joined(scene.messages), contains_text("so \"a.mtl\" was read"));
}

TEST_CASE("what an MTL file asks for in vain is told a keyword a line", "[mtl]") {
    const ParsedMtl parsed = parse_mtl("newmtl a\nKa 1 1 1\nbump a.png\nPr 0.5\nPm 0\n"
                                       "newmtl b\nbump b.png\nmap_Ks c.png\n",
                                       "test.mtl", ".");
    CHECK(parsed.messages ==
          std::vector<std::string>{"test.mtl:3: bump is not shown, 2 times (lines 3, 7).",
                                   "test.mtl:4: Pr is not shown.",
                                   "test.mtl:8: map_Ks is not shown."});
}

TEST_CASE("what glows by a picture does not glow all over and so is no lamp", "[mtl]") {
    const ModelFolder folder("glow");
    const std::string picture = folder.write("c.png", "").string();
    const ParsedMtl parsed = parse_mtl("newmtl a\nmap_Ke c.png\nKe 1 0.5 0.25\n"
                                       "newmtl b\nmap_Ke c.png\nnewmtl c\nKe 1 1 1\nnorm c.png\n",
                                       folder.path() / "test.mtl", folder.path());
    CHECK(parsed.messages.empty());
    CHECK(parsed.materials.at(0).emission == glm::vec3(0.0f));
    CHECK(parsed.materials.at(0).emissive_map == picture);
    CHECK(parsed.materials.at(0).emissive_factor == glm::vec3(1.0f, 0.5f, 0.25f));
    CHECK(parsed.materials.at(1).emissive_factor == glm::vec3(1.0f)); // exports leave Ke out
    CHECK(parsed.materials.at(2).emission == glm::vec3(1.0f));
    CHECK(parsed.materials.at(2).emissive_map.empty());
    CHECK(parsed.materials.at(2).normal_map == picture);
}

TEST_CASE("the picture of an opacity is kept", "[mtl]") {
    const ModelFolder folder("opacity");
    folder.write("b.png", "");
    const ParsedMtl parsed =
        parse_mtl("newmtl a\nmap_d b.png\n", folder.path() / "a.mtl", folder.path());
    CHECK(parsed.materials.at(0).cutout_map == (folder.path() / "b.png").string());
    CHECK(parsed.materials.at(0).cutoff == 0.5f);
}

TEST_CASE("a link does not lead out of the folder of the model", "[mtl]") {
    ModelFolder folder("links");
    folder.write("outside/red.mtl", red);
    const auto model = folder.write("model/a.obj", std::string("mtllib red.mtl\n") + triangle);
    std::filesystem::create_symlink("../outside/red.mtl", folder.path() / "model/red.mtl");
    const Scene scene = load_obj(model);
    CHECK(scene.materials.at(0).name == "default");
    CHECK_THAT(joined(scene.messages), contains_text("is not in the folder of the model"));
}

TEST_CASE("material files in a folder below the model are read", "[mtl]") {
    ModelFolder folder("below");
    folder.write("deep/red.mtl", std::string(red) + "map_Kd ../pictures/a.png\n");
    const Scene scene =
        load_obj(folder.write("a.obj", std::string("mtllib deep\\red.mtl\n") + triangle));
    CHECK(scene.materials.at(0).diffuse == glm::vec3(1, 0, 0));
    CHECK(scene.materials.at(0).diffuse_map == (folder.path() / "pictures/a.png").string());
}

TEST_CASE("a model without its material file is shown in the default material", "[mtl]") {
    const Scene scene = load_obj(corpus_file("library_missing.obj"));
    CHECK(triangle_count(scene) == 1);
    CHECK(scene.materials.size() == 1);
    CHECK_THAT(joined(scene.messages),
               contains_text("library_missing.obj:1: The material file \"gone.mtl\" was not read"));
    CHECK_THAT(joined(scene.messages),
               contains_text("library_missing.obj:6: Material \"red\" is in no MTL file"));
}

TEST_CASE("folders and pipes and files over the limit are no material files", "[mtl]") {
    ModelFolder folder("bad_libraries");
    REQUIRE(mkfifo((folder.path() / "pipe.mtl").c_str(), 0600) == 0);
    std::filesystem::resize_file(folder.write("large.mtl", red), most_mtl_bytes + 1);
    folder.write("zero.mtl", std::string_view("newmtl \0", 8));
    const auto model = folder.write(
        "a.obj",
        std::string("mtllib pipe.mtl\nmtllib large.mtl\nmtllib zero.mtl\nmtllib .\n") + triangle);
    const std::string messages = joined(load_obj(model).messages);
    CHECK_THAT(messages, contains_text("a.obj:1: ") && contains_text("a device or a pipe"));
    CHECK_THAT(messages, contains_text("a.obj:2: ") && contains_text("the limit is 8388608"));
    CHECK_THAT(messages, contains_text("a.obj:3: ") && contains_text("zero byte"));
    CHECK_THAT(messages, contains_text("a.obj:4: ") && contains_text("is a folder"));
}

TEST_CASE("a material file without a material makes none", "[mtl]") {
    const Scene scene = load_obj(corpus_file("library_empty.obj"));
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials[0].name == "default");
    CHECK_THAT(joined(scene.messages),
               contains_text("empty.mtl:1: A line before the first newmtl"));
}

TEST_CASE("a name with spaces is one material file where there is such a file", "[mtl]") {
    CHECK(load_obj(corpus_file("library_with_spaces.obj")).materials.at(0).name == "spaced");
}

TEST_CASE("several material files on a line are all read and each once", "[mtl]") {
    const Scene scene = load_obj(corpus_file("libraries_on_a_line.obj"));
    CHECK(scene.materials.size() == 6); // 3 of cube.mtl and 3 of bad_values.mtl
    CHECK(scene.materials.at(scene.triangle_materials.at(0)).name == "bad");
    CHECK(scene.materials.at(scene.triangle_materials.at(1)).name == "red");
}

TEST_CASE("triangles without a known material get a default that stands last", "[mtl]") {
    const Scene scene = load_obj(corpus_file("material_unknown.obj"));
    REQUIRE(scene.materials.size() == 4);
    CHECK(scene.materials[3].name == "default");
    CHECK(scene.triangle_materials == std::vector<int>{3, 3, 0});
}
