#pragma once

#include "mirror/mirror_scene.h"
#include "structure/structure.h"

namespace raysteps::mirror {

// A mirror with the buffers of the scene and those of a structure that its family built, whichever
// it is: the arrays have the names of the mirror's own members. Both must outlive the mirror.
template <class Mirror>
Mirror mirror_of(const SceneBuffers& scene, const PackedStructure& packed) {
    Mirror mirror = mirror_of<Mirror>(scene);
    if constexpr (requires { mirror.grid_starts; }) {
        mirror.grid_lower = packed.points.at("grid_lower");
        mirror.grid_cell_size = packed.points.at("grid_cell_size");
        mirror.grid_cells = packed.counts.at("grid_cells");
        mirror.grid_starts.texels = packed.integers.at("grid_starts");
        mirror.grid_references.texels = packed.integers.at("grid_references");
    }
    if constexpr (requires { mirror.kd_nodes; }) {
        mirror.kd_nodes.vectors = packed.integer_vectors.at("kd_nodes");
        mirror.kd_references.texels = packed.integers.at("kd_references");
        mirror.kd_lower = packed.points.at("kd_lower");
        mirror.kd_upper = packed.points.at("kd_upper");
    }
    if constexpr (requires { mirror.kd_boxes; }) {
        mirror.kd_boxes.texels = packed.vectors.at("kd_boxes");
    }
    if constexpr (requires { mirror.kd_ropes; }) {
        mirror.kd_ropes.texels = packed.integers.at("kd_ropes");
    }
    if constexpr (requires { mirror.bvh_triangles; }) {
        mirror.bvh_triangles.vectors = packed.integer_vectors.at("bvh_triangles");
        mirror.bvh_node_count = packed.numbers.at("bvh_node_count");
    }
    if constexpr (requires { mirror.bvh_nodes; }) {
        mirror.bvh_nodes.vectors = packed.integer_vectors.at("bvh_nodes");
        mirror.bvh_parents.texels = packed.integers.at("bvh_parents");
    }
    if constexpr (requires { mirror.half_nodes; }) {
        mirror.half_nodes.vectors = packed.integer_vectors.at("half_nodes");
        mirror.half_lower = packed.points.at("half_lower");
        mirror.half_size = packed.points.at("half_size");
    }
    return mirror;
}

} // namespace raysteps::mirror
