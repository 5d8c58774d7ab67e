#include "programs.h"

#include "catch.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <map>

const std::vector<std::string> chapters{"01_rays",    "02_triangles", "03_shading", "04_grid",
                                        "05_kd_tree", "06_bvh",       "07_compare", "08_accuracy",
                                        "09_effects", "10_speed",     "11_paths"};

namespace {

const std::map<std::string, std::string> programs{{"01_rays", PROGRAM_01_RAYS},
                                                  {"02_triangles", PROGRAM_02_TRIANGLES},
                                                  {"03_shading", PROGRAM_03_SHADING},
                                                  {"04_grid", PROGRAM_04_GRID},
                                                  {"05_kd_tree", PROGRAM_05_KD_TREE},
                                                  {"06_bvh", PROGRAM_06_BVH},
                                                  {"07_compare", PROGRAM_07_COMPARE},
                                                  {"08_accuracy", PROGRAM_08_ACCURACY},
                                                  {"09_effects", PROGRAM_09_EFFECTS},
                                                  {"10_speed", PROGRAM_10_SPEED},
                                                  {"11_paths", PROGRAM_11_PATHS},
                                                  {"hard_cases", PROGRAM_HARD_CASES},
                                                  {"check", PROGRAM_CHECK}};

// As one word of a shell's command line.
std::string in_quotes(const std::string& text) {
    std::string quoted = "'";
    for (const char letter : text) {
        quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    }
    return quoted + "'";
}

std::string command_line(const std::string& program, const std::vector<std::string>& arguments) {
    std::string line = "env -u DISPLAY -u WAYLAND_DISPLAY timeout 90 " + in_quotes(program);
    for (const std::string& argument : arguments) {
        line += " ";
        line += in_quotes(argument);
    }
    return line;
}

std::string join_words(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += in_quotes(word);
        text += " ";
    }
    return text;
}

} // namespace

Outcome Workplace::run(const std::string& chapter,
                       const std::vector<std::string>& arguments) const {
    // Beside the folder, so that they are not among its files.
    const std::filesystem::path output = (folder_ / "").parent_path().string() + "_output";
    Outcome outcome = run_into(output, chapter, arguments);
    outcome.output = bytes_of(output);
    std::filesystem::remove(output);
    return outcome;
}

Outcome Workplace::run_into(const std::string& output, const std::string& chapter,
                            const std::vector<std::string>& arguments) const {
    const std::filesystem::path folder = (folder_ / "").parent_path();
    const std::filesystem::path errors = folder.string() + "_errors";
    const std::string line = "cd " + in_quotes(folder.string()) + " && " +
                             command_line(programs.at(chapter), arguments) + " </dev/null >" +
                             in_quotes(output) + " 2>" + in_quotes(errors.string());
    const int status = std::system(line.c_str()); // NOLINT(cert-env33-c): every word is ours
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.errors = bytes_of(errors);
    std::filesystem::remove(errors);
    return outcome;
}

std::vector<std::string> Workplace::list_files() const {
    const std::filesystem::path folder = folder_ / "";
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        files.push_back(std::filesystem::relative(entry.path(), folder).generic_string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void check_refusal(const Workplace& workplace, const std::string& chapter,
                   const std::vector<std::string>& arguments, int exit_code,
                   const std::vector<std::string>& fragments) {
    const std::vector<std::string> files = workplace.list_files();
    const Outcome outcome = workplace.run(chapter, arguments);
    const std::string command = chapter + " " + join_words(arguments);
    CAPTURE(command, outcome.errors);
    CHECK(outcome.exit_code == exit_code);
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
    CHECK(outcome.errors.starts_with(chapter + ": "));
    CHECK(outcome.errors.ends_with(".\n"));
    for (const std::string& fragment : fragments) {
        CHECK_THAT(outcome.errors, contains_text(fragment));
    }
    CHECK(workplace.list_files() == files);
}

void check_refusals(const Workplace& workplace, const std::vector<std::string>& arguments,
                    int exit_code, const std::vector<std::string>& fragments) {
    for (const std::string& chapter : chapters) {
        check_refusal(workplace, chapter, arguments, exit_code, fragments);
    }
}
