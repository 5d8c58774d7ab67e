#pragma once

#include "gpu/live_mask.h"
#include "gpu/program.h"
#include "render/rays.h"
#include "render/scene_textures.h"
#include "render/trace_rays.h"
#include "scene/scene.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// The idea that each slot of the passes takes, by the name of its part.
struct PathChoice {
    std::string random = "sobol";       // where numbers come from
    std::string bounce = "cosine";      // how a path leaves a matte surface
    std::string heuristic = "power";    // how the two ways to a lamp are weighed
    std::string roulette = "by_weight"; // which paths go on
    int max_bounces = 64;
    int seed = 1;
};

// A block of samples is the smallest amount of work, and the order in it never changes.
inline constexpr int samples_per_block = 16;

// What the rays of all blocks came to, as the GPU counts them.
struct PathTally {
    long camera = 0;
    long bounced = 0;  // from matte surfaces, mirrors and glass
    long to_lamps = 0; // to what glows, and to lights that are points
    long cut = 0;      // paths that were alive after max_bounces: what they would find is missing
};

inline long all_rays(const PathTally& tally) {
    return tally.camera + tally.bounced + tally.to_lamps;
}

// What the effects of chapter 09 show of a scene and paths leave out, a sentence each.
std::vector<std::string> left_out_of_paths(const Scene& scene);

// Whether anything in the scene gives light; else every picture of it is black.
bool has_light_for_paths(const Scene& scene);

// Radiance along paths of light, by a wavefront: each pass does one step of all paths. A path goes
// on from each surface in one direction by chance; at matte ones it also sends a ray to a point of
// what glows, and both ways to a lamp are weighed. Light comes from surfaces that glow (Ke) on
// their front, from the sky or the background, and, where nothing glows, from the scene's lights as
// points. Source: Kajiya, "The Rendering Equation", 1986; Veach, "Robust Monte Carlo Methods for
// Light Transport Simulation", 1997.
class PathRenderer {
public:
    // The textures are those of the scene, with the structure that the trace parts walk through.
    // Throws MachineError where a shader does not compile or memory is short, and InputError where
    // a choice names no part.
    PathRenderer(const Scene& scene, SceneTextures textures, const PathChoice& choice,
                 const Parts& trace_parts, const Limits& limits);

    // For each pixel the sum of the samples 16 * block ... 16 * block + 15, the bottom row first.
    // The bits depend on nothing else than scene, choice, camera, size and block. `side_by_side`
    // is how many samples are traced at once, a power of two up to 16, or 0 for what fits.
    std::vector<glm::vec4> render_block(const Camera& camera, int width, int height, int block,
                                        int side_by_side = 0);

    // 1 for each pixel that may see a lamp, row by row from the top: its middle does, or a
    // neighbour's.
    std::vector<std::uint8_t> pixels_with_lamps(const Camera& camera, int width, int height);

    // Of all blocks so far.
    const PathTally& tally() const { return tally_; }

private:
    struct Paths; // of a launch: one per texel
    void follow(Paths& paths);
    void add_point_lights(Paths& paths, const Texture& hits);
    void meet_glow_by_rays(Paths& paths, const Texture& hits, int bounce);
    void leave_surfaces(Paths& paths, const Texture& hits, int bounce);
    Program& pass(const std::string& name) { return passes_.at(name); }
    Program& at_hits(const std::string& name, const Paths& paths, const Texture& hits);

    PathChoice choice_;
    std::vector<std::uint8_t> glowing_; // 1 for each triangle that does
    SceneTextures scene_;
    std::vector<Light> point_lights_;
    std::map<std::string, BufferTexture> buffers_; // of emitters and glass, by their uniforms
    bool has_sky_ = false;
    bool has_emitters_ = false;
    bool has_mirrors_ = false;
    bool has_glass_ = false;
    bool absorbs_ = false;
    TraceRays trace_;
    std::map<std::string, Program> passes_;
    int texture_size_;
    PathTally tally_;
};

} // namespace raysteps
