#include "basics/error.h"
#include "catch.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/limits.h"
#include "gpu/program.h"
#include "gpu/shaders.h"

#include <filesystem>
#include <fstream>

using namespace raysteps;

namespace {

// A folder of shader files that goes when the test ends.
class ShaderFolder {
public:
    ShaderFolder() {
        path_ = std::filesystem::temp_directory_path() /
                ("raysteps_shaders_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
        std::filesystem::create_directories(path_);
    }
    ~ShaderFolder() { std::filesystem::remove_all(path_); }
    ShaderFolder(const ShaderFolder&) = delete;
    ShaderFolder& operator=(const ShaderFolder&) = delete;

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name) << text;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string sentence_of(const auto& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("an include is replaced by the file and a slot by its part", "[gpu][read_shader]") {
    const ShaderFolder folder;
    folder.write("pass.frag", "#version 410 core\n#include \"a.glsl\"\n#include <slot>\nlast\n");
    folder.write("a.glsl", "text of a\n");
    folder.write("b.glsl", "text of b\n");
    const ShaderText shader = read_shader("pass.frag", {{"slot", "b.glsl"}}, folder.path());
    CHECK(shader.text == "#version 410 core\n#line 100001\ntext of a\n#line 3\n"
                         "#line 200001\ntext of b\n#line 4\nlast\n");
    CHECK(shader.files == std::vector<std::string>{"pass.frag", "a.glsl", "b.glsl"});
}

TEST_CASE("a missing file and an unfilled slot and a circle are named with file and line",
          "[gpu][read_shader]") {
    const ShaderFolder folder;
    folder.write("missing.frag", "#version 410 core\n\n#include \"nowhere.glsl\"\n");
    folder.write("slot.frag", "#version 410 core\n#include <structure>\n");
    folder.write("circle.glsl", "#include \"circle.glsl\"\n");
    const auto read = [&](const std::string& pass) {
        return sentence_of([&] { read_shader(pass, {}, folder.path()); });
    };
    CHECK_THAT(read("missing.frag"), starts_with_text("missing.frag:3: the shader file"));
    CHECK_THAT(read("slot.frag"),
               starts_with_text("slot.frag:2: nothing fills the slot <structure>"));
    CHECK_THAT(read("circle.glsl"), starts_with_text("circle.glsl:1: `circle.glsl` is "
                                                     "included in a circle"));
}

TEST_CASE("messages of every kind of compiler get the names of the files", "[gpu][read_shader]") {
    const std::vector<std::string> files{"pass.frag", "part.glsl"};
    CHECK(name_files("0:100012(5): error: no", files) == "part.glsl:12: error: no\n");
    CHECK(name_files("0(100012) : error C0000: no", files) == "part.glsl:12: error C0000: no\n");
    CHECK(name_files("ERROR: 0:100012: 'x' : no", files) == "part.glsl:12: 'x' : no\n");
    CHECK(name_files("0:700012(5): error: of a file unknown", files) ==
          "0:700012(5): error: of a file unknown\n");
    CHECK(name_files("2 errors generated", files) == "2 errors generated\n");
}

TEST_CASE("the compiler of this machine names the line of the part that is wrong", "[gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const std::string sentence = sentence_of([] {
        Program("pass/trace/trace.frag", {{"triangle", "exhibit/paper_as_printed.glsl"},
                                          {"cutout", "cutout/none.glsl"},
                                          {"structure", "structure/every_triangle.glsl"},
                                          {"observer", "observer/none.glsl"}});
    });
    CAPTURE(sentence);
    CHECK_THAT(sentence, starts_with_text("The shader pass/trace/trace.frag does not compile"));
    CHECK_THAT(sentence, contains_text("exhibit/paper_as_printed.glsl:30:"));
}

TEST_CASE("a pass is found by its name, so no two have the same", "[gpu]") {
    for (const ProgramRecipe& recipe : list_programs()) {
        CHECK(find_pass(std::filesystem::path(recipe.pass).stem().string()) == recipe.pass);
    }
}

TEST_CASE("every program that can be composed compiles and links", "[gpu]") {
    const auto context = make_context(ContextKind::automatic);
    const std::vector<ProgramRecipe> programs = list_programs();
    REQUIRE(programs.size() >= 10);
    for (const ProgramRecipe& recipe : programs) {
        std::string parts;
        for (const auto& [slot, file] : recipe.parts) {
            parts += " " + file;
        }
        CAPTURE(recipe.pass, parts);
        CHECK_NOTHROW(Program(recipe.pass, recipe.parts));
    }
}
