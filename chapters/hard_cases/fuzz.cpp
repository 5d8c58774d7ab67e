#include "fuzz.h"

#include "basics/error.h"
#include "basics/file.h"
#include "hard_cases/hard_cases.h"
#include "mirror/trace_by_mirror.h"
#include "scene/ray_file.h"
#include "structure/padding.h"
#include "structure/structure.h"
#include "tally.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace raysteps {

namespace {

constexpr int scenes_to_one_on_the_gpu = 64;

Scene scene_of(const HardScene& made) {
    return add_mesh(Scene{}, made.mesh, Material{});
}

// Built for these rays, as far as their origins are numbers that a builder can plan with.
BuiltStructure build(const std::string& structure, const HardScene& made) {
    const StructureFamily family = family_of(structure);
    const auto values = made.build_values.find(family.name);
    const float reach = reach_of(made.rays, made.mesh.corners);
    return family.build(made.mesh.corners, {.reach = std::isfinite(reach) ? reach : 0.0f,
                                            .values = values == made.build_values.end()
                                                          ? std::map<std::string, std::string>{}
                                                          : values->second});
}

template <class MakeMethod>
std::vector<FuzzMethod> for_each_structure(const MakeMethod& make) {
    std::vector<FuzzMethod> methods{make("every_triangle")};
    for (const auto& [name, walk] : mirror_walks()) {
        if (name != "every_triangle") {
            methods.push_back(make(name));
        }
    }
    return methods;
}

std::string to_text(const Hit& hit) {
    return "triangle " + std::to_string(hit.triangle) + " at " + std::to_string(hit.t);
}

// Nine digits tell every float from its neighbours.
std::string to_text(float number) {
    return fmt::format("{:.9g}", number);
}

std::string to_text(const glm::vec3& point, const std::string& separator) {
    return to_text(point.x) + separator + to_text(point.y) + separator + to_text(point.z);
}

} // namespace

std::string to_obj(const Mesh& mesh) {
    std::string text;
    for (const glm::vec3& corner : mesh.corners) {
        text += "v " + to_text(corner, " ") + "\n";
    }
    for (std::size_t i = 1; i + 2 <= mesh.corners.size(); i += 3) {
        text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " +
                std::to_string(i + 2) + "\n";
    }
    return text;
}

std::vector<FuzzMethod> fuzz_methods() {
    return for_each_structure([](const std::string& structure) {
        const TraceByMirror trace = mirror_walks().at(structure);
        return FuzzMethod{structure, [=](const HardScene& made) {
                              const mirror::SceneBuffers buffers(scene_of(made));
                              const BuiltStructure built = build(structure, made);
                              return trace(buffers, built.packed, made.rays);
                          }};
    });
}

std::vector<FuzzMethod> fuzz_methods(GpuMethods& gpu) {
    return for_each_structure([&gpu](const std::string& structure) {
        return FuzzMethod{structure + " on the GPU", [&gpu, structure](const HardScene& made) {
                              return gpu.trace("watertight", structure,
                                               upload(scene_of(made), build(structure, made)),
                                               upload_rays(made.rays), made.rays.size());
                          }};
    });
}

std::optional<FuzzFault> find_different_hit(const HardScene& made,
                                            const std::vector<FuzzMethod>& methods) {
    const std::vector<Hit> loop = methods.front().trace(made);
    for (std::size_t m = 1; m < methods.size(); ++m) {
        const std::vector<Hit> hits = methods[m].trace(made);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (count_other_hits(std::span(&hits[i], 1), std::span(&loop[i], 1)) > 0) {
                return FuzzFault{0, methods[m].name,
                                 "finds " + to_text(hits[i]) + ", the loop " + to_text(loop[i]),
                                 made};
            }
        }
    }
    return std::nullopt;
}

std::optional<FuzzFault> find_no_answer(const HardScene& made,
                                        const std::vector<FuzzMethod>& methods) {
    const auto triangles = static_cast<int>(made.mesh.corners.size() / 3);
    for (std::size_t m = 1; m < methods.size(); ++m) {
        try {
            const std::vector<Hit> hits = methods[m].trace(made);
            if (!is_finite(made.mesh)) {
                return FuzzFault{0, methods[m].name, "accepts a scene that is not finite", made};
            }
            if (count_unanswered(hits, triangles) > 0) {
                return FuzzFault{0, methods[m].name, "gives no answer", made};
            }
        } catch (const InputError&) {
            continue; // refused, in a sentence
        }
    }
    return std::nullopt;
}

FuzzFault shrink(FuzzFault fault, const std::vector<FuzzMethod>& methods, FindFault find) {
    const int seed = fault.seed;
    // Parts that are left out grow smaller, down to single rays and triangles.
    const auto shrink_list = [&](auto list_of, std::size_t stride) {
        for (std::size_t part = list_of(fault.made).size() / stride; part > 0; part /= 2) {
            for (std::size_t begin = 0; begin < list_of(fault.made).size();) {
                HardScene less = fault.made;
                auto& list = list_of(less);
                const std::size_t end = std::min(begin + part * stride, list.size());
                list.erase(list.begin() + begin, list.begin() + end);
                less.mesh.normals.resize(less.mesh.corners.size());
                auto still = find(less, methods);
                if (still) {
                    fault = std::move(*still);
                } else {
                    begin = end;
                }
            }
        }
    };
    shrink_list([](HardScene& made) -> std::vector<Ray>& { return made.rays; }, 1);
    shrink_list([](HardScene& made) -> std::vector<glm::vec3>& { return made.mesh.corners; }, 3);
    fault.seed = seed;
    return fault;
}

FuzzResult fuzz(const FuzzRequest& request) {
    const std::vector<FuzzMethod> by_mirror = fuzz_methods();
    const std::vector<FuzzMethod> by_gpu =
        request.gpu == nullptr ? std::vector<FuzzMethod>{} : fuzz_methods(*request.gpu);
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    FuzzResult result;
    for (int seed = request.first_seed; seconds() < request.seconds; ++seed, ++result.scenes) {
        request.progress(seconds() / request.seconds);
        const bool on_gpu = !by_gpu.empty() && seed % scenes_to_one_on_the_gpu == 0;
        const std::vector<FuzzMethod>& methods = on_gpu ? by_gpu : by_mirror;
        for (const auto& [make, find] : {std::pair{&awkward_scene, &find_different_hit},
                                         std::pair{&garbage_scene, &find_no_answer}}) {
            const HardScene made = make(seed);
            result.walks += made.rays.size() * methods.size();
            std::optional<FuzzFault> fault = find(made, methods);
            if (fault) {
                fault->seed = seed;
                result.fault = shrink(std::move(*fault), methods, find);
                request.progress(1.0);
                return result;
            }
        }
    }
    request.progress(1.0);
    return result;
}

std::vector<std::filesystem::path> write_fault(const FuzzFault& fault,
                                               const std::filesystem::path& folder) {
    const std::string name = "fuzz_" + std::to_string(fault.seed);
    const std::vector<std::filesystem::path> paths{folder / (name + ".obj"),
                                                   folder / (name + ".csv")};
    write_file(paths[0], to_obj(fault.made.mesh));
    write_ray_file(paths[1], fault.made.rays);
    return paths;
}

} // namespace raysteps
