#pragma once

#include "program/options.h"
#include "structure/structure.h"

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// What the programs that trace are asked: which walk through which structure, built how.
struct TraceOptions {
    std::string triangle = "watertight";
    std::string structure = "every_triangle";
    std::map<std::string, std::string> build_values{}; // of the builders' own options, by name
    std::filesystem::path rays{};                      // empty: those of a picture
    std::filesystem::path hits{};
};

// The names of the parts that fill a slot of a GPU program: `triangle`, `structure` or `view`.
std::vector<std::string> part_names(const std::string& slot);

// --triangle --structure --rays --hits, and the options of all builders.
void add_trace_options(Options& options, TraceOptions& tracing);

// The same without --structure, for a program that has one of its own.
void add_walk_options(Options& options, TraceOptions& tracing);

// The options of all builders by themselves, --tree among them.
void add_build_options(Options& options, std::map<std::string, std::string>& values);

// What there is to see of a picture: the parts of shaders/view, then `visits` and `tests`.
std::vector<std::string> view_names();

// Throws InputError where the view is of visits, and the walk visits nothing.
void refuse_empty_heat_map(const std::string& view, const TraceOptions& tracing);

// --view: a part of shaders/view, or the heat map of what a walk through the structure did: its
// visits (cells or nodes) or its tests (triangles). Of the loop over every triangle, which visits
// nothing, the heat map is that of its tests.
void add_view_option(Options& options, std::string& view, const TraceOptions& tracing);

using Builder =
    std::function<BuiltStructure(std::span<const glm::vec3> corners, const BuildRequest& request)>;

// Builds the structure of that name over the triangles, three corners each, and prints the facts
// of it. Its family's builder does it, or the one that a chapter has of its own for that family.
// Throws InputError where the request has a value that the builder has no option for, and
// MachineError where the GPU of the current context could not read the structure.
BuiltStructure build_structure(const std::string& structure, std::span<const glm::vec3> corners,
                               BuildRequest request,
                               const std::map<std::string, Builder>& own_builders = {});

// How far from any corner the rays of the scene's camera start, along each axis: from its eye, its
// lens, and in a window from wherever a person may move it.
float camera_reach(const PictureOptions& picture, const Scene& scene);

} // namespace raysteps
