#include "render/packets.h"

#include "basics/timed.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "scene/view.h"
#include "structure/padding.h"
#include "structure/structure.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <thread>

namespace raysteps {

namespace {

constexpr long fragments_per_tile = 64L * 64L;
constexpr long tiles_per_processor = 2;
constexpr long rays_per_packet = 4;

// A ball of 5,120 triangles that fills most of a small picture: coherent rays, as in any scene, and
// some 20 milliseconds of work each way. Both ways take turns, and the best of three counts: what
// else the machine does can only slow a run down.
constexpr int batch_side = 256;
constexpr int rounds = 3;

bool measure(const std::string& structure, const TraceBatch& trace) {
    const Scene scene = add_mesh({}, sphere(glm::vec3(0.0f), 1.5f, 16), Material{});
    const float reach = reach_of(origins_of(scene.camera), scene.corners);
    const SceneTextures textures =
        upload(scene, family_of(structure).build(scene.corners, {.reach = reach}));
    const RayTextures rays =
        generate_rays(scene.camera, batch_side, batch_side, RayGeneration::direct);
    const auto seconds = [&](Packets packets) {
        return timed([&] { return trace(rays, textures, packets), 0; }).second;
    };
    double together = std::numeric_limits<double>::max();
    double alone = together;
    for (int round = 0; round <= rounds; ++round) {
        const double now_together = seconds(Packets::always);
        const double now_alone = seconds(Packets::never);
        if (round > 0) { // in the first one, drivers compile
            together = std::min(together, now_together);
            alone = std::min(alone, now_alone);
        }
    }
    return together < alone;
}

} // namespace

long least_rays_for_packets() {
    const long processors = std::max(1U, std::thread::hardware_concurrency());
    return processors * tiles_per_processor * fragments_per_tile * rays_per_packet;
}

bool packets_are_faster(const std::string& structure, const TraceBatch& trace) {
    static std::optional<bool> known;
    if (!known) {
        known = measure(structure, trace);
    }
    return *known;
}

} // namespace raysteps
