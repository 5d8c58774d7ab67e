#include "catch.h"
#include "gpu/program.h"
#include "gpu/shaders.h"
#include "support/scratch_folder.h"

#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace raysteps;

// Khronos' own compiler is stricter than the drivers, each of which lets something through.

namespace {

const std::string no_complaint;

int run_in_shell(const std::string& command) {
    return std::system(command.c_str()); // NOLINT(cert-env33-c): every word of it is ours
}

// The messages of the compiler about the shader; empty where it has none.
std::string complaints(const ScratchFolder& folder, const ShaderText& shader,
                       const std::string& stage) {
    const std::filesystem::path text = folder / ("shader." + stage);
    const std::filesystem::path log = folder / "log";
    put_bytes(text, shader.text);
    const int result = run_in_shell("glslangValidator -S " + stage + " '" + text.string() + "' >'" +
                                    log.string() + "'");
    return result == 0 ? "" : name_files(bytes_of(log), shader.files);
}

void require_glslang() {
    if (run_in_shell("glslangValidator --version >/dev/null 2>&1") != 0) {
        FAIL("glslangValidator is missing. Install the package glslang-tools.");
    }
}

} // namespace

TEST_CASE("glslang names the line of a part that is wrong", "[architecture][shaders]") {
    require_glslang();
    const ScratchFolder folder("architecture_glslang_fault");
    const ShaderText shader =
        read_shader("pass/trace/trace.frag", {{"real", "real/float.glsl"},
                                              {"triangle", "exhibit/paper_as_printed.glsl"},
                                              {"cutout", "cutout/none.glsl"},
                                              {"structure", "structure/every_triangle.glsl"},
                                              {"observer", "observer/none.glsl"}});
    CHECK_THAT(complaints(folder, shader, "frag"),
               contains_text("exhibit/paper_as_printed.glsl:30: 'a' : redefinition"));
}

TEST_CASE("every program that can be composed passes glslang", "[architecture][shaders]") {
    require_glslang();
    const ScratchFolder folder("architecture_glslang");
    const std::vector<ProgramRecipe> programs = list_programs();
    REQUIRE(programs.size() >= 10);
    std::set<std::string> seen;
    std::vector<std::pair<std::string, ShaderText>> shaders;
    std::map<std::string, std::string> commands; // for each stage
    for (const ProgramRecipe& recipe : programs) {
        Parts parts = recipe.parts;
        parts.try_emplace("real", "real/float.glsl");
        for (const std::string& pass : {recipe.pass, vertex_pass_of(recipe.pass)}) {
            ShaderText shader = read_shader(pass, parts);
            if (!seen.insert(shader.text).second) {
                continue;
            }
            const std::string stage = pass.substr(pass.find('.') + 1);
            const std::filesystem::path file =
                folder / (std::to_string(shaders.size()) + "." + stage);
            put_bytes(file, shader.text);
            commands.try_emplace(stage, "glslangValidator -t -S " + stage).first->second +=
                " '" + file.string() + "'";
            shaders.emplace_back(stage, std::move(shader));
        }
    }
    // All of a stage at once, which takes a tenth of the time. Only where one is wrong, each by
    // itself.
    for (const auto& [stage, command] : commands) {
        if (run_in_shell(command + " >'" + (folder / "all").string() + "'") == 0) {
            continue;
        }
        FAIL_CHECK("glslangValidator refuses a " << stage << " program");
        for (const auto& [own_stage, shader] : shaders) {
            std::string files;
            for (const std::string& file : shader.files) {
                files += file + " ";
            }
            CAPTURE(files);
            if (own_stage == stage) {
                CHECK(complaints(folder, shader, stage) == no_complaint);
            }
        }
    }
    CHECK(seen.size() > programs.size()); // each fragment pass, and the vertex passes
}
