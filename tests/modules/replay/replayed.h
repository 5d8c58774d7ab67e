#pragma once

#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/padding.h"
#include "structure/structure.h"
#include "support/gpu_hits.h"
#include "visualizer/replay/recorded_path.h"
#include "visualizer/replay/structure_cells.h"
#include "visualizer/replay/walk_recorder.h"

#include <map>
#include <memory>
#include <string>

namespace raysteps {

// A scene with its structure, whose walks can be recorded.
struct Replayed {
    Replayed(const Scene& given, const std::string& structure, float reach,
             const std::map<std::string, std::string>& values = {})
        : scene(given), buffers(scene),
          built(family_of(structure).build(scene.corners, {reach, values})),
          cells(cells_of(built.packed, {})),
          recorder(make_recorder(structure, {buffers, built.packed})) {}
    Replayed(const Replayed&) = delete;
    Replayed& operator=(const Replayed&) = delete;

    Scene scene;
    mirror::SceneBuffers buffers;
    BuiltStructure built;
    StructureCells cells;
    WalkRecorder recorder;
};

// One triangle before another, as seen from z = -1 along +z.
inline Scene two_triangles(float apart = 1.0f) {
    return scene_of(join(triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}),
                         triangle({-1, -1, apart}, {1, -1, apart}, {0, 1, apart})));
}

inline constexpr Ray along_z{{0.0f, 0.0f, -1.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end};

} // namespace raysteps
