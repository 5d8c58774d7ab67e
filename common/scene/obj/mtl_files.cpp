#include "scene/mtl_files.h"

#include "error/error.h"
#include "file/read_file.h"
#include "scene/check_is_text.h"
#include "scene/obj_lines.h"
#include "scene/obj_paths.h"

#include <optional>
#include <set>

namespace raysteps {

namespace {

// One name with spaces in it, where there is such a file; else names that spaces set apart.
std::vector<std::string_view> names_in(const ObjLibrary& library,
                                       const std::filesystem::path& folder) {
    const auto path = path_inside(folder, folder, library.name);
    std::error_code failure;
    if (path && std::filesystem::exists(*path, failure))
        return {library.name};
    return split_words(library.name);
}

// The file's text, or why it cannot be had.
struct Outcome {
    std::string text;
    std::string problem;
};

Outcome read_mtl_file(const std::filesystem::path& path) {
    try {
        Outcome outcome{read_file(path, most_mtl_bytes), ""};
        check_is_text(outcome.text, path);
        return outcome;
    } catch (const InputError& error) {
        return {"", error.what()};
    }
}

} // namespace

MtlFiles read_mtl_files(const ObjFile& file) {
    MtlFiles result;
    std::set<std::filesystem::path> seen;
    const std::filesystem::path folder = folder_of(file.path);
    for (const ObjLibrary& library : file.libraries) {
        for (const std::string_view name : names_in(library, folder)) {
            const auto path = path_inside(folder, folder, name);
            if (!path) {
                result.findings.note("The material file " + in_quotes(name) +
                                         " is not in the folder of the model, so it was not read",
                                     library.line);
                continue;
            }
            if (!seen.insert(*path).second)
                continue;
            Outcome outcome = read_mtl_file(*path);
            if (outcome.problem.empty())
                result.files.push_back({*path, std::move(outcome.text)});
            else
                result.findings.note("The material file " + in_quotes(name) +
                                         " was not read, because " + outcome.problem,
                                     library.line);
        }
    }
    return result;
}

} // namespace raysteps
