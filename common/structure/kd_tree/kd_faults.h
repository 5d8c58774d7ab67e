#pragma once

#include "structure/kd_tree.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The checks that check_kd_tree is made of. Each needs those before it to have found nothing.
using KdFaults = std::vector<std::string>;

KdFaults faults_of_links(const KdTree& tree);
KdFaults faults_of_boxes(const KdTree& tree);
KdFaults faults_of_references(const KdTree& tree, std::size_t triangles);
KdFaults faults_of_ropes(const KdTree& tree);
KdFaults missing_references(const KdTree& tree, std::span<const glm::vec3> corners);

} // namespace raysteps
