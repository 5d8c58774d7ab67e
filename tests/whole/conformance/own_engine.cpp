// Our own walks and triangle tests as an engine for the conformance suite:
//   own_engine cpp|gpu STRUCTURE|test:TRIANGLE %t %r %h
#include "basics/file.h"
#include "gpu/context.h"
#include "hard_cases/gpu_methods.h"
#include "hard_cases/meshes.h"
#include "mirror/trace_by_mirror.h"
#include "reference/exact.h"
#include "scene/ray_file.h"
#include "structure/padding.h"
#include "structure/structure.h"

#include <cstring>
#include <iostream>

using namespace raysteps;

namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 32;
const std::string only_a_test = "test:";

template <class Record>
std::vector<Record> records_of(const std::string& path) {
    const std::string bytes = read_file(path, most_bytes);
    std::vector<Record> records(bytes.size() / sizeof(Record));
    if (!records.empty()) {
        std::memcpy(records.data(), bytes.data(), records.size() * sizeof(Record));
    }
    return records;
}

// Rays that are none have no reach.
float reach_of_usable(std::span<const Ray> rays, std::span<const glm::vec3> corners) {
    std::vector<Ray> usable;
    std::copy_if(rays.begin(), rays.end(), std::back_inserter(usable), is_usable);
    return usable.empty() || corners.empty() ? 0.0f : reach_of(usable, corners);
}

std::vector<Hit> trace_on_gpu(const std::string& triangle, const std::string& structure,
                              const Scene& scene, const BuiltStructure& built,
                              std::span<const Ray> rays) {
    const auto context = make_context(ContextKind::automatic);
    GpuMethods methods(measure_limits());
    return methods.trace(triangle, structure, upload(scene, built), upload_rays(rays), rays.size());
}

std::vector<Hit> trace(const std::string& by, const std::string& name, const Scene& scene,
                       std::span<const Ray> rays) {
    const bool is_test = name.starts_with(only_a_test);
    const std::string triangle = is_test ? name.substr(only_a_test.size()) : "watertight";
    const std::string structure = is_test ? "every_triangle" : name;
    const BuiltStructure built =
        family_of(structure).build(scene.corners, {.reach = reach_of_usable(rays, scene.corners)});
    if (by == "gpu") {
        return trace_on_gpu(triangle, structure, scene, built, rays);
    }
    const auto& methods = is_test ? mirror_triangle_tests() : mirror_walks();
    return methods.at(is_test ? triangle : structure)(mirror::SceneBuffers(scene), built.packed,
                                                      rays);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 6) {
        std::cerr << "own_engine: give cpp or gpu, a structure or test:NAME, and three files.\n";
        return 2;
    }
    try {
        const Scene scene = add_mesh(Scene{}, mesh_of(records_of<glm::vec3>(argv[3])), Material{});
        write_hit_file(argv[5], trace(argv[1], argv[2], scene, records_of<Ray>(argv[4])));
    } catch (const std::exception& error) {
        std::cerr << "own_engine: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
