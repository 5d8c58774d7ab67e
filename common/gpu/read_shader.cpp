#include "gpu/read_shader.h"

#include "error/error.h"
#include "gpu/shader_path.h"

#include <fstream>
#include <regex>
#include <sstream>

namespace raysteps {

namespace {

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

} // namespace

std::filesystem::path shader_folder() {
    return RAYSTEPS_SHADER_DIR;
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

} // namespace raysteps
