#include "gpu/shader_catalog.h"

#include "error/error.h"
#include "gpu/shader_path.h"

#include <algorithm>
#include <fstream>
#include <regex>

namespace raysteps {

namespace {

std::vector<std::filesystem::path> list_files(const std::string& extension) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(shader_folder(), error)) {
        if (entry.path().extension() == extension) {
            files.push_back(std::filesystem::relative(entry.path(), shader_folder()));
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> slots_of(const std::string& pass) {
    static const std::regex include(R"(^\s*#\s*include\s*<([^>]+)>.*$)");
    std::ifstream stream(find_shader(pass, shader_folder()));
    std::vector<std::string> slots;
    std::string line;
    while (std::getline(stream, line)) {
        std::smatch match;
        if (std::regex_match(line, match, include)) {
            slots.push_back(match[1]);
        }
    }
    return slots;
}

} // namespace

std::vector<NamedPart> list_parts(const std::string& slot) {
    std::vector<NamedPart> parts;
    for (const std::filesystem::path& file : list_files(".glsl")) {
        const std::string stem = file.stem().string();
        if (file.parent_path() == slot) {
            parts.push_back({stem, file.generic_string()});
        } else if (stem.starts_with(slot + "_")) {
            parts.push_back({stem.substr(slot.size() + 1), file.generic_string()});
        }
    }
    std::sort(parts.begin(), parts.end(),
              [](const NamedPart& a, const NamedPart& b) { return a.name < b.name; });
    return parts;
}

std::string find_part(const std::string& slot, const std::string& name) {
    std::string names;
    for (const NamedPart& part : list_parts(slot)) {
        if (part.name == name) {
            return part.file;
        }
        names += (names.empty() ? "" : ", ") + part.name;
    }
    if (names.empty()) {
        throw MachineError(shader_folder().string() + ": holds no part for the slot <" + slot +
                           ">. Get the shaders back, or build again where the project is now.");
    }
    throw InputError("--" + slot + " " + name + ": there is no such part. Take one of " + names +
                     ".");
}

std::vector<ProgramRecipe> list_programs() {
    std::vector<ProgramRecipe> programs;
    for (const std::filesystem::path& file : list_files(".frag")) {
        std::vector<ProgramRecipe> choices{{file.generic_string(), {}}};
        for (const std::string& slot : slots_of(file.generic_string())) {
            std::vector<ProgramRecipe> extended;
            for (const ProgramRecipe& choice : choices) {
                for (const NamedPart& part : list_parts(slot)) {
                    extended.push_back(choice);
                    extended.back().parts[slot] = part.file;
                }
            }
            choices = std::move(extended);
        }
        programs.insert(programs.end(), choices.begin(), choices.end());
    }
    return programs;
}

} // namespace raysteps
