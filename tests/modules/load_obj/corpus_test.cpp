#include "first_fault.h"
#include "model_folder.h"

#include "basics/error.h"
#include "scene/obj/load_obj.h"

#include "catch.h"

#include <filesystem>
#include <vector>

using namespace raysteps;

namespace {

std::vector<std::filesystem::path> corpus_of(const std::string& extension) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(corpus_file("")))
        if (entry.path().extension() == extension)
            files.push_back(entry.path());
    return files;
}

} // namespace

TEST_CASE("every file of the corpus ends in a sound scene or in a sentence that names it",
          "[obj]") {
    const std::vector<std::filesystem::path> files = corpus_of(".obj");
    REQUIRE(files.size() >= 60);
    for (const std::filesystem::path& file : files) {
        CAPTURE(file.filename());
        try {
            const Scene scene = load_obj(file);
            CHECK(first_fault(scene).empty());
        } catch (const InputError& error) {
            CHECK_THAT(error.what(), contains_text(file.filename().string() + ":"));
            CHECK(std::string(error.what()).back() == '.');
        }
    }
}

TEST_CASE("every file of the corpus cut short anywhere still ends in one of the two", "[obj]") {
    const std::string text = "mtllib cube.mtl\nv 0 0 0\nv 1e0 0 0\nv 0 -1.5 0\nvt 0.5 0.5\n"
                             "vn 0 0 1\ns 1\nusemtl red\nf 1/1/1 2//1 -1/-1 1\n";
    for (std::size_t length = 0; length <= text.size(); ++length) {
        CAPTURE(length);
        try {
            const Scene scene = parse_obj(text.substr(0, length), corpus_file("short.obj"));
            CHECK(first_fault(scene).empty());
        } catch (const InputError& error) {
            CHECK_THAT(error.what(), contains_text("short.obj:"));
        }
    }
}

TEST_CASE("every material file of the corpus ends in sound materials", "[mtl]") {
    for (const std::filesystem::path& file : corpus_of(".mtl")) {
        CAPTURE(file.filename());
        const std::string name = file.filename().string();
        ModelFolder folder("every_mtl");
        std::filesystem::copy_file(file, folder.path() / name);
        const Scene scene = load_obj(folder.write("model.obj", "mtllib " + name + "\n"));
        CHECK(first_fault(scene).empty());
    }
}
