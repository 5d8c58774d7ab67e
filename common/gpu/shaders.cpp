#include "gpu/shaders.h"

#include "basics/data_folder.h"
#include "basics/error.h"
#include "basics/text.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace raysteps {

namespace {

// Those of the environment variable RAYSTEPS_SHADERS, which come first.
std::vector<std::filesystem::path> folders_of_environment() {
    const char* named = std::getenv("RAYSTEPS_SHADERS"); // NOLINT(concurrency-mt-unsafe)
    std::istringstream words(named == nullptr ? "" : named);
    std::vector<std::filesystem::path> folders;
    for (std::string word; std::getline(words, word, ':');) {
        if (!word.empty()) {
            folders.emplace_back(word);
        }
    }
    return folders;
}

// Deeper nesting is a circle of includes.
constexpr int deepest_include = 16;

// Where an include stands: what a person has to look at when it fails.
struct Place {
    std::string file;
    int line = 0;
};

std::string to_string(const Place& place) {
    return place.line == 0 ? place.file : place.file + ":" + std::to_string(place.line);
}

class Reader {
public:
    Reader(const Parts& parts, const std::filesystem::path& folder)
        : parts_(parts), folder_(folder) {}

    void read(const std::string& file, const Place& from, int depth) {
        if (depth > deepest_include) {
            throw MachineError(to_string(from) + ": `" + file +
                               "` is included in a circle. Remove one of the includes.");
        }
        const std::filesystem::path path = find_shader(file, folder_);
        std::ifstream stream(path);
        if (!stream || std::filesystem::is_directory(path)) {
            throw MachineError(to_string(from) + ": the shader file `" + file +
                               "` cannot be read in " + folder_.string() +
                               ". Check its name, or get it back from the repository.");
        }
        const std::size_t number = shader_.files.size();
        shader_.files.push_back(file);
        if (depth > 0) {
            say_line(1, number);
        }
        std::string line;
        for (int count = 1; std::getline(stream, line); ++count) {
            read_line(line, {file, count}, number, depth);
        }
    }

    ShaderText take() { return std::move(shader_); }

private:
    void read_line(const std::string& line, const Place& place, std::size_t number, int depth) {
        static const std::regex include(R"(^\s*#\s*include\s*(?:"([^"]+)\"|<([^>]+)>).*$)");
        std::smatch match;
        if (!std::regex_match(line, match, include)) {
            shader_.text += line + "\n";
            return;
        }
        read(match[1].matched ? match[1].str() : part_for(match[2].str(), place), place, depth + 1);
        say_line(place.line + 1, number);
    }

    const std::string& part_for(const std::string& slot, const Place& place) const {
        const auto part = parts_.find(slot);
        if (part == parts_.end()) {
            throw MachineError(to_string(place) + ": nothing fills the slot <" + slot +
                               ">. Name a part for it where the program is made.");
        }
        return part->second;
    }

    void say_line(int line, std::size_t number) {
        const std::size_t global = number * lines_per_file + static_cast<std::size_t>(line);
        shader_.text += "#line " + std::to_string(global) + "\n";
    }

    const Parts& parts_;
    std::filesystem::path folder_;
    ShaderText shader_;
};

// The files of that extension in the shader folder and in those of the environment, each once.
std::vector<std::filesystem::path> list_files(const std::string& extension) {
    std::vector<std::filesystem::path> folders = folders_of_environment();
    folders.push_back(shader_folder());
    std::set<std::filesystem::path> files;
    for (const std::filesystem::path& folder : folders) {
        std::error_code error;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
            if (entry.path().extension() == extension) {
                files.insert(std::filesystem::relative(entry.path(), folder));
            }
        }
    }
    return {files.begin(), files.end()};
}

// A slot whose parts stand in a folder that also holds what several of them share, or the parts of
// another slot: what a part defines that fills it.
struct Role {
    std::string slot;
    std::string folder;
    std::string function;
};

const std::vector<Role>& roles() {
    static const std::vector<Role> all{{"structure", "structure", "go_on"},
                                       {"packet", "structure", "walk_packet"},
                                       {"triangle", "triangle", "intersect_triangle"},
                                       {"offset", "offset", "leaving_point"},
                                       {"slab", "slab", "meets_slabs"}};
    return all;
}

bool fills(const std::filesystem::path& file, const std::string& slot) {
    const auto role = std::ranges::find(roles(), slot, &Role::slot);
    if (role == roles().end()) {
        return *file.begin() == slot;
    }
    if (*file.begin() != role->folder) {
        return false;
    }
    const std::regex definition(R"(^\w+ )" + role->function + R"(\(.*)");
    std::ifstream stream(find_shader(file.generic_string(), shader_folder()));
    for (std::string line; std::getline(stream, line);) {
        if (std::regex_match(line, definition)) {
            return true;
        }
    }
    return false;
}

// A walk asks a part for cut-outs nothing but a hit, whatever test made it and whoever observes:
// one of each will do.
bool has_needless_cutout(const ProgramRecipe& recipe) {
    const auto is_other = [&](const char* slot, const char* part) {
        const auto chosen = recipe.parts.find(slot);
        return chosen != recipe.parts.end() && chosen->second != part;
    };
    return is_other("cutout", "cutout/none.glsl") &&
           (is_other("triangle", "triangle/watertight.glsl") ||
            is_other("observer", "observer/none.glsl") || is_other("real", "real/float.glsl"));
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

std::filesystem::path find_shader(const std::string& file, const std::filesystem::path& folder) {
    for (const std::filesystem::path& first : folders_of_environment()) {
        if (std::filesystem::is_regular_file(first / file)) {
            return first / file;
        }
    }
    return folder / file;
}

std::filesystem::path shader_folder() {
    return data_folder(RAYSTEPS_SHADER_DIR, "shaders");
}

ShaderText read_shader(const std::string& pass, const Parts& parts,
                       const std::filesystem::path& folder) {
    Reader reader(parts, folder);
    reader.read(pass, {pass, 0}, 0);
    return reader.take();
}

std::string name_files(const std::string& messages, const std::vector<std::string>& files) {
    // Mesa: "0:12(5): error", NVIDIA: "0(12) : error", AMD, Apple and glslang: "ERROR: 0:12: ".
    static const std::regex notation(
        R"(^(?:(?:ERROR|WARNING): )?\d+(?::(\d{1,9})(?:\(\d+\))?|\((\d{1,9})\))\s*:\s*)");
    std::istringstream lines(messages);
    std::string named;
    std::string line;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (std::regex_search(line, match, notation)) {
            const auto global = std::stoul(match[1].matched ? match[1] : match[2]);
            const std::size_t file = global / lines_per_file;
            if (file < files.size()) {
                line = files[file] + ":" + std::to_string(global % lines_per_file) + ": " +
                       match.suffix().str();
            }
        }
        named += line + "\n";
    }
    return named;
}

std::vector<NamedPart> list_parts(const std::string& slot) {
    std::vector<NamedPart> parts;
    for (const std::filesystem::path& file : list_files(".glsl")) {
        if (fills(file, slot)) {
            parts.push_back({file.stem().string(), file.generic_string()});
        }
    }
    std::sort(parts.begin(), parts.end(),
              [](const NamedPart& a, const NamedPart& b) { return a.name < b.name; });
    return parts;
}

std::string find_part(const std::string& slot, const std::string& name) {
    const std::vector<NamedPart> parts = list_parts(slot);
    std::vector<std::string_view> names;
    for (const NamedPart& part : parts) {
        if (part.name == name) {
            return part.file;
        }
        names.emplace_back(part.name);
    }
    if (names.empty()) {
        throw MachineError(shader_folder().string() + ": holds no part for the slot <" + slot +
                           ">. Get the shaders back, or build again where the project is now.");
    }
    throw InputError(no_such_choice("--" + slot, name, "part", names));
}

std::string find_pass(const std::string& name) {
    for (const std::filesystem::path& file : list_files(".frag")) {
        if (file.stem() == name) {
            return file.generic_string();
        }
    }
    throw MachineError(shader_folder().string() + ": holds no pass " + name +
                       ".frag. Check its name, or get it back from the repository.");
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
        std::erase_if(choices, has_needless_cutout);
        programs.insert(programs.end(), choices.begin(), choices.end());
    }
    return programs;
}

} // namespace raysteps
