#include "structure/check_kd_tree.h"

#include "structure/kd_faults.h"

#include <algorithm>
#include <cstddef>

namespace raysteps {

namespace {

constexpr std::size_t most_of_a_kind = 10;

} // namespace

std::vector<std::string> check_kd_tree(const KdTree& tree, std::span<const glm::vec3> corners) {
    KdFaults faults = faults_of_links(tree);
    if (faults.empty()) {
        faults = faults_of_references(tree, corners.size() / 3);
    }
    if (faults.empty()) {
        for (const KdFaults& more :
             {faults_of_boxes(tree), faults_of_ropes(tree), missing_references(tree, corners)}) {
            const std::size_t count = std::min(more.size(), most_of_a_kind);
            faults.insert(faults.end(), more.begin(),
                          more.begin() + static_cast<std::ptrdiff_t>(count));
        }
        return faults;
    }
    faults.resize(std::min(faults.size(), most_of_a_kind));
    return faults;
}

} // namespace raysteps
