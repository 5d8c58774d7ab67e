#include "scene/import/load_import.h"

#include "basics/data_folder.h"
#include "basics/error.h"
#include "basics/file.h"
#include "scene/import/mesh_file.h"
#include "scene/obj/load_obj.h"
#include "scene/obj/mtl.h"
#include "scene/scaling.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace raysteps {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = std::uintmax_t{16} << 30;

// A file that goes away with its owner.
class PassingFile {
public:
    PassingFile() : path_((fs::temp_directory_path() / "raysteps_mesh_XXXXXX").string()) {
        const int file = mkstemp(path_.data());
        if (file < 0) {
            throw MachineError(path_ + ": no file can be made there (" + std::strerror(errno) +
                               "). Make room, or name another folder in TMPDIR.");
        }
        close(file);
    }
    ~PassingFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    PassingFile(const PassingFile&) = delete;
    PassingFile& operator=(const PassingFile&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

std::string reason_of(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL) {
            return "it took more time or memory than is allowed";
        }
        return std::string("the library that reads it stopped: ") + strsignal(signal);
    }
    return "the importer ended with the exit code " + std::to_string(WEXITSTATUS(status));
}

// Runs the importer and waits for it; its answer is in the file then.
int run_importer(const fs::path& model, const std::string& answer) {
    const std::string program = helper_program(RAYSTEPS_IMPORTER).string();
    const std::string named = fs::absolute(model).string();
    std::array<char*, 4> arguments{const_cast<char*>(program.c_str()),
                                   const_cast<char*>(named.c_str()),
                                   const_cast<char*>(answer.c_str()), nullptr};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int failure =
        posix_spawn(&child, program.c_str(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (failure != 0) {
        throw MachineError(program + ": the importer cannot be started (" + std::strerror(failure) +
                           "). Build or install Raysteps again.");
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

// The importer's exit codes are those of all programs; then its answer is a sentence.
std::string import_bytes(const fs::path& path) {
    const PassingFile answer;
    const int status = run_importer(path, answer.path());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (code == static_cast<int>(ExitCode::done)) {
        return read_file(answer.path(), most_bytes);
    }
    if (code == static_cast<int>(ExitCode::wrong_input)) {
        throw InputError(path.string() + ": " + read_file(answer.path(), most_bytes));
    }
    if (code == static_cast<int>(ExitCode::machine_lacks)) {
        throw MachineError(path.string() + ": " + read_file(answer.path(), most_bytes));
    }
    throw InputError(path.string() + ": it cannot be imported: " + reason_of(status) +
                     ". Check the export, or try another format.");
}

ObjFace face_of(const MeshGroup& group, int number, std::size_t first_corner, int corner_count) {
    ObjFace face;
    face.line = number;
    face.first_corner = first_corner;
    face.corner_count = corner_count;
    face.material_name = group.material;
    face.number = number;
    return face;
}

// Each vertex has one place, one normal and one texture coordinate.
void add_corners(ObjFile& file, const MeshFile& mesh) {
    for (const std::uint32_t corner : mesh.corners) {
        const int index = static_cast<int>(corner);
        const bool has_normal = !mesh.normals.empty() && file.normals[corner] != glm::vec3(0.0f);
        file.corners.push_back({index, mesh.texture_coordinates.empty() ? not_given : index,
                                has_normal ? index : not_given});
    }
}

// Faces are counted within their group, as its file counts them.
void add_faces(ObjFile& file, const MeshFile& mesh) {
    std::size_t first_corner = 0;
    for (std::size_t i = 0; i < mesh.groups.size(); ++i) {
        const MeshGroup& group = mesh.groups[i];
        const std::uint64_t end =
            i + 1 < mesh.groups.size() ? mesh.groups[i + 1].first_face : mesh.sizes.size();
        for (std::uint64_t face = group.first_face; face < end; ++face) {
            const int size = static_cast<int>(mesh.sizes[face]);
            file.faces.push_back(
                face_of(group, static_cast<int>(face - group.first_face) + 1, first_corner, size));
            file.faces.back().object = static_cast<int>(i);
            first_corner += mesh.sizes[face];
        }
    }
}

glm::vec3 unit_or_zero(const glm::vec3& given) {
    const glm::dvec3 normal(given);
    const double length = glm::length(normal);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(normal / length) : glm::vec3(0.0f);
}

ObjFile to_obj_file(const MeshFile& mesh, const fs::path& path, Origin origin) {
    ObjFile file;
    file.path = path;
    file.counts = FindingsCount::faces;
    if (origin == Origin::near_model) {
        DoubleBox box;
        for (const std::uint32_t corner : mesh.corners) {
            extend(box, mesh.positions[corner]);
        }
        file.origin = offset_of(box);
    }
    for (const glm::dvec3& position : mesh.positions) {
        file.positions.emplace_back(position - file.origin);
    }
    for (const glm::vec3& normal : mesh.normals) {
        file.normals.push_back(unit_or_zero(normal));
    }
    file.texture_coordinates = mesh.texture_coordinates;
    file.colors = mesh.colors;
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        file.material_names.push_back(std::to_string(i)); // names may be the same
    }
    for (const MeshGroup& group : mesh.groups) {
        file.objects.push_back(group.object);
        file.primitives.push_back(group.primitive);
    }
    add_corners(file, mesh);
    add_faces(file, mesh);
    return file;
}

// A picture in the file itself keeps its name; the others are looked for.
std::string picture_path(const MeshFile& mesh, const std::string& name, const fs::path& path,
                         std::vector<std::string>& messages) {
    const bool is_enclosed =
        std::any_of(mesh.pictures.begin(), mesh.pictures.end(),
                    [&](const EnclosedPicture& picture) { return picture.name == name; });
    if (name.empty() || is_enclosed) {
        return name;
    }
    const MtlTexture found = find_texture(name, path, folder_of(path));
    if (!found.message.empty() &&
        std::find(messages.begin(), messages.end(), found.message) == messages.end()) {
        messages.push_back(found.message);
    }
    return found.path;
}

Scene to_scene(const MeshFile& mesh, const fs::path& path, Origin origin) {
    std::vector<Material> materials = mesh.materials;
    std::vector<std::string> messages;
    for (const std::string& message : mesh.messages) {
        messages.push_back(path.string() + ": " + message);
    }
    for (std::size_t i = 0; i < materials.size(); ++i) {
        materials[i].diffuse_map = picture_path(mesh, materials[i].diffuse_map, path, messages);
        materials[i].cutout_map = picture_path(mesh, materials[i].cutout_map, path, messages);
        materials[i].normal_map = picture_path(mesh, materials[i].normal_map, path, messages);
        materials[i].emissive_map = picture_path(mesh, materials[i].emissive_map, path, messages);
        materials[i].name = std::to_string(i);
    }
    Scene scene = make_scene(to_obj_file(mesh, path, origin), std::move(materials));
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        scene.materials[i].name = mesh.materials[i].name;
    }
    scene.enclosed = mesh.pictures;
    scene.lights = mesh.lights;
    scene.file_camera = mesh.camera;
    if (scene.origin != glm::dvec3(0.0)) {
        for (Light& light : scene.lights) {
            light.position = as_seen_from(scene.origin, glm::dvec3(light.position));
        }
        if (scene.file_camera) {
            *scene.file_camera = moved(*scene.file_camera, -scene.origin);
        }
    }
    messages.insert(messages.end(), scene.messages.begin(), scene.messages.end());
    scene.messages = std::move(messages);
    return scene;
}

} // namespace

const std::vector<std::string>& imported_endings() {
    static const std::vector<std::string> endings{".gltf", ".glb", ".stl", ".fbx",
                                                  ".dae",  ".3ds", ".off"};
    return endings;
}

Scene load_import(const fs::path& path, Origin origin) {
    std::error_code failure;
    if (!fs::is_regular_file(path, failure)) {
        throw InputError(path.string() + ": there is no such file. Check the name.");
    }
    const MeshFile mesh = read_mesh_file(import_bytes(path), path);
    return to_scene(mesh, path, origin);
}

} // namespace raysteps
