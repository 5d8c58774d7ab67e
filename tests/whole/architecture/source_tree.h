#pragma once

#include <filesystem>
#include <string>
#include <vector>

// The files of a source tree as text: what the rules of the architecture are checked on. Paths are
// relative to the tree's root, with slashes.

inline const std::vector<std::string> cpp_folders{"common", "chapters", "visualizer", "scripts",
                                                  "tests"};
inline const std::vector<std::string> cpp_endings{".h", ".cpp", ".inc"};

// The regular files in the folders, sorted; with a name that ends in one of the endings, or all
// where none is given.
std::vector<std::string> list_files(const std::filesystem::path& root,
                                    const std::vector<std::string>& folders,
                                    const std::vector<std::string>& endings = {});

// The names of the folders in the folder that hold a CMakeLists.txt, sorted.
std::vector<std::string> list_targets(const std::filesystem::path& root, const std::string& folder);

// A file's lines, without the `//` comments of C++ and GLSL. Line n is at n - 1.
std::vector<std::string> code_lines(const std::filesystem::path& file);

// An #include of C++: `"scene/scene.h"` is quoted, `<vector>` is not.
struct Include {
    std::string name;
    bool quoted = false;
    int line = 0;
};

std::vector<Include> includes_of(const std::filesystem::path& file);

// The file that an include names, from the root: beside the file itself, or in one of the folders
// that the compiler is told. Empty where the file is none of ours.
std::string find_included(const std::filesystem::path& root, const std::string& from,
                          const std::string& name);

// The words that stand after a keyword in the first call of a command in a CMake file, up to the
// next word in capitals. Empty where there is no such call or keyword.
std::vector<std::string> words_of_call(const std::filesystem::path& file,
                                       const std::string& command, const std::string& keyword);

// `FILE:LINE: what`, the form of every fault.
std::string fault_at(const std::string& file, int line, const std::string& what);

inline const std::vector<std::string> no_faults{};

// One a line, as a test spells them out.
std::string join_lines(const std::vector<std::string>& lines);
