#include "program/figures.h"

#include "basics/error.h"
#include "basics/file.h"
#include "gpu/context.h"
#include "scene/camera_text.h"

#include <built_commit.inc>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

namespace raysteps {

namespace {

// Of a comparison in a thousand scenes.
constexpr std::uintmax_t most_bytes_of_figures = 64U << 20U;

// UTC, as ISO 8601 has it.
std::string now() {
    const std::time_t time = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
    return text;
}

// As Linux calls the processor; where it does not, its architecture.
std::string processor_name() {
    std::ifstream processors("/proc/cpuinfo");
    std::string line;
    while (std::getline(processors, line)) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    utsname machine{};
    return uname(&machine) == 0 ? machine.machine : "unknown";
}

// Shaders are read when a program starts: a folder of the person's own may take their place.
bool has_modified_tree() {
    const char* const own_shaders = std::getenv("RAYSTEPS_SHADERS");
    return built_from_modified_tree || (own_shaders != nullptr && *own_shaders != '\0');
}

Numbers head_numbers(const FiguresHead& head) {
    Numbers numbers{{"schema", head.schema},
                    {"schema_version", schema_version},
                    {"commit", built_commit},
                    {"modified", has_modified_tree()},
                    {"date", now()},
                    {"cpu", processor_name()},
                    {"cores", std::thread::hardware_concurrency()},
                    {"renderer", Numbers()},
                    {"opengl", Numbers()},
                    {"builders", empty_object()},
                    {"scenes", empty_list()}};
    if (const auto opengl = current_opengl()) {
        numbers["renderer"] = opengl->renderer;
        numbers["opengl"] = opengl->version;
    }
    for (const auto& [structure, options] : head.builders) {
        numbers["builders"][structure] = empty_object();
        for (const auto& [name, value] : options) {
            numbers["builders"][structure][name] = value;
        }
    }
    for (const SceneRecord& scene : head.scenes) {
        numbers["scenes"].push_back({{"scene", scene.scene},
                                     {"hash", scene.hash},
                                     {"triangles", scene.triangles},
                                     {"camera", scene.camera}});
    }
    return numbers;
}

} // namespace

SceneRecord record_of(const Scene& scene) {
    return {scene.name, hash_of(scene), triangle_count(scene),
            camera_text(scene.camera, {0.0f, 1.0f, 0.0f}, scene.origin)};
}

std::string version_in_words() {
    return std::string("Raysteps ") + RAYSTEPS_VERSION + ", commit " + built_commit +
           (has_modified_tree() ? ", modified" : "");
}

Numbers with_head(const FiguresHead& head, const Numbers& figures) {
    Numbers all{{"head", head_numbers(head)}};
    for (const auto& [name, value] : figures.members()) {
        all[name] = value;
    }
    return all;
}

void write_figures(const std::filesystem::path& path, const FiguresHead& head,
                   const Numbers& figures) {
    if (!path.empty()) {
        write_text(path, with_head(head, figures).to_json() + "\n");
    }
}

Numbers read_figures(const std::filesystem::path& path, const std::string& schema) {
    const Numbers file = parse_json(read_file(path, most_bytes_of_figures), path);
    const bool is_object = std::holds_alternative<Numbers::Object>(file.value());
    const Numbers* const head = is_object ? file.find("head") : nullptr;
    if (head == nullptr) {
        throw InputError(path.string() + ": the file has no head, so it was not written by --json "
                                         "of this version of Raysteps. Measure it again.");
    }
    const std::string& own_schema = head->at("schema").text();
    const double version = head->at("schema_version").number();
    if (own_schema != schema) {
        throw InputError(path.string() + ": the file is of " + own_schema + ", but one of " +
                         schema + " is needed. Name another.");
    }
    if (version != schema_version) {
        throw InputError(
            path.string() + ": the file has version " + std::to_string(static_cast<int>(version)) +
            " of its schema, and this program writes version " + std::to_string(schema_version) +
            ". Measure it again with this program, or compare by one of its age.");
    }
    return file;
}

} // namespace raysteps
