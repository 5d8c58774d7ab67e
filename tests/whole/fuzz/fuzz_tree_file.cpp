// Whatever the bytes are, as a tree file they end in a tree or in an InputError; and a tree, in
// figures and, where a walk can go through it, in arrays. Anything else stops the program, and
// libFuzzer keeps the bytes.
#include "basics/error.h"
#include "structure/bvh/check_bvh.h"
#include "structure/tree_file/tree_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

// The triangles of tests/chapters/check/corpus.
const std::array<glm::vec3, 12> corners{{{2, 0, 0},
                                         {3, 1, 0},
                                         {2, 0, 1},
                                         {0, 0, 0},
                                         {1, 1, 0},
                                         {0, 0, 1},
                                         {0, 5, 0},
                                         {1, 5, 0},
                                         {0, 5, 1},
                                         {0, 7, 0},
                                         {1, 7, 0},
                                         {0, 7, 1}}};

void use(const raysteps::BoxTree& tree) {
    raysteps::find_faults(tree, corners, 0.1);
    raysteps::measure_box_tree(tree, {});
    if (tree.width == 2) {
        raysteps::pack(raysteps::bvh_of(tree, corners.size() / 3), corners);
    }
    raysteps::pack(raysteps::bvh4_of(tree, corners.size() / 3), corners);
}

void use(const raysteps::KdTree& tree) {
    raysteps::pack(tree);
}

void use(const raysteps::Grid& grid) {
    raysteps::pack(grid);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    try {
        const std::string_view text(reinterpret_cast<const char*>(bytes), count);
        const raysteps::AnyTree tree =
            raysteps::in_numbers_of(raysteps::parse_tree_file(text, "fuzz.rstree"), corners);
        std::visit([](const auto& own) { use(own); }, tree);
    } catch (const raysteps::InputError&) {
    }
    return 0;
}
