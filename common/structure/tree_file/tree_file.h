#pragma once

#include "basics/error.h"
#include "structure/bvh/box_tree.h"
#include "structure/grid/grid.h"
#include "structure/kd_tree/kd_tree.h"

#include <glm/vec3.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raysteps {

using AnyTree = std::variant<BoxTree, KdTree, Grid>;

// A structure as a file has it (docs/tree_files.md): of anybody's, and of our own builders.
struct TreeFile {
    std::string made_by; // what built it, in words; may be empty
    AnyTree tree;
    // Three a triangle, where the file has triangles of its own: then its numbers count these.
    std::vector<glm::vec3> corners{};
};

// Reads the file. What is wrong within the tree is for find_faults and others to say; of a kd-tree
// and a grid, what is derived (boxes, ropes, neighbours) is made here, so their links, boxes and
// lists must be sound. Throws InputError, with the file and the place in it, where it is no tree
// file, is cut short, or is of a kind that is not read.
TreeFile read_tree_file(const std::filesystem::path& path);

// The same of a file's bytes; the path names it in sentences.
TreeFile parse_tree_file(std::string_view bytes, const std::filesystem::path& path);

// Our own structures, to be read again with the same bits. Throws InputError.
void write_tree_file(const std::filesystem::path& path, const TreeFile& file);
std::string tree_file_bytes(const TreeFile& file);

// The tree with the numbers of the triangles of these corners. Where the file has triangles of its
// own, each is looked up by the bits of its corners, in their order or turned; one that is not
// there becomes far_out.
AnyTree in_numbers_of(TreeFile file, std::span<const glm::vec3> corners);

// `a hierarchy of boxes`, `a kd-tree` or `a grid`.
std::string kind_of(const AnyTree& tree);

// What a family asks whose walks can go through a file's tree.
inline const BuildOption tree_option{
    "tree", "", "go through the tree of this file (docs/tree_files.md) instead of building one"};

// The file that the request names; empty where it names none. Throws InputError where it has other
// values that only a builder could heed.
std::string asked_tree(const BuildRequest& request);

// The tree of that file over these triangles, as `convert` makes it of a Tree. Throws InputError as
// read_tree_file does, and where the tree is of another kind or no walk can go through it.
template <class Tree, class Convert>
auto tree_from_file(const std::string& path, std::span<const glm::vec3> corners,
                    const Convert& convert) {
    TreeFile file = read_tree_file(path);
    if (!std::holds_alternative<Tree>(file.tree)) {
        throw InputError(path + ": this is " + kind_of(file.tree) +
                         ", and these walks go through another kind. Take another --structure.");
    }
    try {
        return convert(std::get<Tree>(in_numbers_of(std::move(file), corners)));
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.what());
    }
}

} // namespace raysteps
