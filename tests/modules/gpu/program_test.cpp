#include "catch.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "sentence_of.h"

using namespace raysteps;

TEST_CASE("a pass has the vertex pass of its name or else the full screen", "[gpu][program]") {
    CHECK(vertex_pass_of("pass/rays/interpolate_rays.frag") == "pass/rays/interpolate_rays.vert");
    CHECK(vertex_pass_of("pass/trace/trace.frag") == "pass/full_screen.vert");
}

TEST_CASE("a fault in a vertex pass is named with pass and line", "[gpu][program]") {
    const auto context = make_context(ContextKind::automatic);
    // A part that needs what only a real part defines cannot take its place.
    const std::string sentence = machine_sentence_of([] {
        Program("pass/rays/interpolate_rays.frag", {{"real", "core/vector.glsl"}});
    });
    CAPTURE(sentence);
    CHECK_THAT(sentence, starts_with_text(
                             "The shader pass/rays/interpolate_rays.vert does not compile. Fix"));
    CHECK_THAT(sentence, contains_text("core/vector.glsl:4:"));
}

TEST_CASE("a pass that is no file is refused by its name", "[gpu][program]") {
    const auto context = make_context(ContextKind::automatic);
    CHECK_THAT(machine_sentence_of([] { Program("pass/nowhere.frag"); }),
               starts_with_text("pass/nowhere.frag: the shader file `pass/nowhere.frag` cannot be "
                                "read"));
}

TEST_CASE("a uniform that no part uses is passed over", "[gpu][program]") {
    const auto context = make_context(ContextKind::automatic);
    const Texture texture(TexelFormat::rgba32f, 1, 1);
    Program program("pass/light/start_weights.frag");
    program.set("nobody", 1).set("nobody", 1.0f).set("nobody", glm::vec3(1.0f));
    program.set("nobody", texture);
    CHECK_NOTHROW(draw(program, {.textures = {texture}}));
    CHECK(read_floats(texture).front() == glm::vec4(1.0f));
}

TEST_CASE("a texture that is set anew takes the place of the old one", "[gpu][program]") {
    const auto context = make_context(ContextKind::automatic);
    const std::vector<glm::uvec4> old_texels{glm::uvec4(1u)};
    const std::vector<glm::uvec4> new_texels{glm::uvec4(2u)};
    const Texture old_texture(TexelFormat::rgba32ui, 1, 1);
    const Texture new_texture(TexelFormat::rgba32ui, 1, 1);
    const Texture target(TexelFormat::rgba32ui, 1, 1);
    write_texels(old_texture, old_texels);
    write_texels(new_texture, new_texels);
    Program program("pass/trace/probe_bits.frag");
    program.set("bits", old_texture).set("bits", new_texture);
    draw(program, {.textures = {target}});
    CHECK(read_integers(target) == new_texels);
}

TEST_CASE("a moved program still draws", "[gpu][program]") {
    const auto context = make_context(ContextKind::automatic);
    const Texture texture(TexelFormat::rgba32f, 1, 1);
    Program first("pass/light/start_weights.frag");
    Program second(std::move(first));
    Program third("pass/select/select_all.frag");
    third = std::move(second);
    draw(third, {.textures = {texture}});
    CHECK(read_floats(texture).front() == glm::vec4(1.0f));
}

TEST_CASE("what the machine lacks ends a program with the exit code 3", "[gpu][error]") {
    CHECK(MachineError("").code() == ExitCode::machine_lacks);
    CHECK(static_cast<int>(ExitCode::machine_lacks) == 3);
}
