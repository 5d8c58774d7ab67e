#pragma once

#include "gpu/live_mask.h"
#include "gpu/program.h"
#include "image/image.h"
#include "render/effects/effect_buffers.h"
#include "render/effects/plan.h"
#include "render/rays.h"
#include "render/scene_textures.h"
#include "render/trace_rays.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raysteps {

// What a picture took, counted by the GPU (occlusion queries), and what it was spared.
struct RayTally {
    long camera = 0;
    long shadow = 0;       // to lights that are points
    long soft_shadow = 0;  // to points of lights with an area
    long behind_glass = 0; // shadow rays that went on behind glass
    long mirror = 0;
    long refracted = 0;          // or totally reflected
    long reflected_by_glass = 0; // the second ray at a hit

    long facing_away = 0;   // shadow rays that were not cast: the lamp is behind the surface
    long lamps_skipped = 0; // lamps that no surface of a bounce faces
    long faint = 0;         // rays that were not sent on: they would count too little
    int waves = 0;          // steps of the wavefront: traces of nearest hits
    int deepest = 0;        // bounces after which no path lived any more

    std::size_t most_listed = 0; // rays of the longest list behind glass
};

// The kinds of rays by name, as they are printed.
std::vector<std::pair<std::string, long>> kinds_of(const RayTally& tally);

long all_rays(const RayTally& tally);

// Rays that are about to be traced, one per texel, and what they count for their pixels. Where
// `targets` is empty, each ray belongs to the pixel of its texel; else `targets` has the pixel of
// each, the bottom row of the picture first.
struct Branch {
    RayTextures rays;
    Texture weights;
    std::optional<Texture> media; // light/media.glsl, where the plan has refraction
    std::unique_ptr<LiveMask> live;
    std::vector<std::int32_t> targets;
    int bounce = 0;
};

enum class Media { none, kept };

Branch make_branch(int width, int height, Media media);

// Rays on their way from textures to a list.
struct RayList {
    std::vector<glm::vec4> origins;
    std::vector<glm::vec4> directions;
    std::vector<glm::vec4> weights;
    std::vector<glm::uvec4> media;
    std::vector<std::int32_t> targets;
};

// What became of the rays of a branch: at most two each.
struct Gathered {
    RayList list;
    long second_sent = 0;
    long second_faint = 0; // that would have counted something, but too little
};

// The rays of both branches that count more than `faintest`, without gaps: for each texel the first
// branch's, then the second's. The targets are those of the branch that they come from.
Gathered gather(const Branch& first, const Branch& second, const Branch& parent, float faintest);

// The list as textures, cut into pieces of at most `most_rays_per_piece`.
std::vector<Branch> upload_list(const RayList& list, int bounce);

inline constexpr std::size_t most_rays_per_piece = std::size_t{1} << 21;

// Where the live paths of a picture are: their rays, what these hit, and what they count.
struct PathsAtHits {
    const RayTextures& rays;
    const Texture& hits;
    const Texture& weights;
    const LiveMask& live;
};

// Adds the light of the scene's lamps to a picture, with the effects of the plan. Lights come
// one after the other, so each pixel gets its sums in the same order whatever the plan.
class Lamps {
public:
    Lamps(std::vector<Light> lights, const Plan& plan);

    // Of all paths at once. `sample` is that of the camera's rays.
    void light(const PathsAtHits& paths, const Texture& color, int sample, PlannedPasses& passes,
               TraceRays& trace, const SceneTextures& scene, RayTally& tally) const;

private:
    std::vector<Light> lights_;
    Plan plan_;
};

// A picture of a scene with the effects of a plan, as a wavefront: each pass does one step of all
// paths. While a pixel has one path, its ray is at the pixel's texel. From the first glass on,
// where paths split in two, the rays of a bounce are a list without gaps, and each carries what it
// finds to its pixel; the next bounce's list has up to two for each of this one's. So Whitted's
// tree of rays is walked level by level. Source: Whitted, "An Improved Illumination Model for
// Shaded Display", 1980.
class EffectsRenderer {
public:
    // The textures are those of the scene, with the structure that the parts walk through. Throws
    // MachineError where a shader does not compile or memory is short.
    EffectsRenderer(const Scene& scene, SceneTextures textures, const Plan& plan,
                    const Parts& trace_parts, const Limits& limits);

    // The camera must call for no other effects than that of the plan's scene.
    Image render(const Camera& camera, int width, int height);

    // Of the last picture.
    const RayTally& tally() const { return tally_; }

    // Of the effects' own arrays.
    std::size_t effect_bytes() const { return effects_.bytes; }

    // Of textures that could not be read.
    const std::vector<std::string>& messages() const { return effects_.messages; }

    void report_progress(Progress progress) { progress_ = std::move(progress); }

private:
    RayTextures camera_rays(const Camera& camera, int width, int height, int sample);
    void follow(Branch branch, const Texture& color, int sample);
    void shade(Branch& branch, const Texture& hits, const Texture& light, int sample);
    void carry_to_pixels(const Branch& branch, const Texture& light, const Texture& color);
    bool mirror(Branch& branch, const Texture& hits);
    void split_at_glass(const Branch& branch, const Texture& hits);
    Program& at_hits(const std::string& pass, const Branch& branch, const Texture& hits);

    Plan plan_;
    SceneTextures scene_;
    EffectBuffers effects_;
    TraceRays trace_;
    PlannedPasses passes_;
    Lamps lamps_;
    std::vector<Branch> waiting_;
    RayTally tally_;
    Progress progress_ = [](double) {};
};

// What the last picture took: rays by kind, rays and passes that it was spared, and textures.
std::string explain(const EffectsRenderer& renderer);

} // namespace raysteps
