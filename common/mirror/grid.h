#pragma once

#include "mirror/mirror_scene.h"
#include "structure/grid/grid.h"

namespace raysteps::mirror {

// The walks through a uniform grid, in single or double precision.

template <class Real>
struct GridWatertight {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/grid/grid.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct GridMailboxWatertight {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/grid/grid_mailbox.glsl"
#include "mirror/parts.inc"
};

// The same with somebody who counts.

template <class Real>
struct GridCounted {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/grid/grid.glsl"
#define OBSERVER_PART "observer/count.glsl"
#include "mirror/parts.inc"
};

template <class Real>
struct GridMailboxCounted {
#define TRIANGLE_PART "triangle/watertight.glsl"
#define STRUCTURE_PART "structure/grid/grid_mailbox.glsl"
#define OBSERVER_PART "observer/count.glsl"
#include "mirror/parts.inc"
};

// A mirror with the buffers of the scene and its grid, both of which must outlive it.
template <class Mirror>
Mirror mirror_of(const SceneBuffers& buffers, const Grid& grid) {
    Mirror mirror = mirror_of<Mirror>(buffers);
    mirror.grid_lower = grid.shape.lower;
    mirror.grid_cell_size = grid.shape.cell_size;
    mirror.grid_cells = grid.shape.cells;
    mirror.grid_starts.texels = grid.starts;
    mirror.grid_references.texels = grid.references;
    return mirror;
}

} // namespace raysteps::mirror
