#pragma once

#include "program/output.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <vector>

namespace raysteps {

// The version of the schemas of all files that --json writes: it grows when a name or a meaning
// changes, so that figures of two versions are never compared.
inline constexpr int schema_version = 1;

// Which scene was used: stable from machine to machine.
struct SceneRecord {
    std::string scene; // its name
    std::string hash;  // of hash_of
    int triangles = 0;
    std::string camera; // as --camera has it
};

SceneRecord record_of(const Scene& scene);

// What the head of a file of --json is told; the rest of it (version, commit, date, machine) it
// finds out by itself. docs/figures.md describes it.
struct FiguresHead {
    std::string schema; // the file beside the program that describes the figures
    std::vector<SceneRecord> scenes{};
    // The options of the builders, by the name of the structure: those that were not given too.
    std::map<std::string, std::map<std::string, std::string>> builders{};
};

// `Raysteps 0.1.0, commit 1234...`, and whether the tree differed from it.
std::string version_in_words();

// The figures, which are an object, under their head.
Numbers with_head(const FiguresHead& head, const Numbers& figures);

// The same as the file of --json; nothing where none is named. A renderer is named where a context
// lives.
void write_figures(const std::filesystem::path& path, const FiguresHead& head,
                   const Numbers& figures);

// The figures of an earlier run, with their head. Throws InputError where the file is no JSON, or
// is not of this schema and version.
Numbers read_figures(const std::filesystem::path& path, const std::string& schema);

} // namespace raysteps
