#pragma once

#include "gpu_methods.h"
#include "hard_cases/hard_case.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// A way to trace a scene, built with its options. Throws InputError where its builder refuses.
struct FuzzMethod {
    std::string name;
    std::function<std::vector<Hit>(const HardScene& made)> trace;
};

// Every structure as C++; the first one is the loop over every triangle.
std::vector<FuzzMethod> fuzz_methods();

// The same on the GPU, which must outlive them.
std::vector<FuzzMethod> fuzz_methods(GpuMethods& gpu);

// What went wrong, with the smallest scene that was found to show it.
struct FuzzFault {
    int seed = 0;
    std::string method;
    std::string what;
    HardScene made;
};

// The fault of any method at a scene: a hit that is not the loop's. None where all agree.
std::optional<FuzzFault> find_different_hit(const HardScene& made,
                                            const std::vector<FuzzMethod>& methods);

// The fault of any method at a scene of garbage: no answer, or a scene with numbers that are not
// finite and is not refused.
std::optional<FuzzFault> find_no_answer(const HardScene& made,
                                        const std::vector<FuzzMethod>& methods);

using FindFault = std::optional<FuzzFault> (*)(const HardScene& made,
                                               const std::vector<FuzzMethod>& methods);

// The fault with as few triangles and rays as still show it.
FuzzFault shrink(FuzzFault fault, const std::vector<FuzzMethod>& methods, FindFault find);

struct FuzzRequest {
    int first_seed = 1;
    double seconds = 1.0;
    GpuMethods* gpu = nullptr; // where given, one scene of 64 goes to the GPU too
    Progress progress = [](double) {};
};

struct FuzzResult {
    int scenes = 0;
    std::size_t walks = 0;
    std::optional<FuzzFault> fault; // shrunk
};

// Awkward and garbage scenes of one seed after another (hard_cases/hard_cases.h), until the time is
// up or a fault is found.
FuzzResult fuzz(const FuzzRequest& request);

// The mesh as an OBJ file, with all digits.
std::string to_obj(const Mesh& mesh);

// Writes the fault's mesh as an OBJ file and its rays as a .csv file of that folder, with all
// digits, so that the chapters' programs can trace them: --scene and --rays. Returns the paths.
std::vector<std::filesystem::path> write_fault(const FuzzFault& fault,
                                               const std::filesystem::path& folder);

} // namespace raysteps
