#pragma once

#include "gpu/live_mask.h"
#include "render/rays.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
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

// Rays that are about to be traced, one a texel, and what they count for their pixels. Where
// `targets` is empty, each ray belongs to the pixel of its place; else `targets` has the pixel of
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

// The rays of both branches that count more than `faintest`, without gaps: of each place the first
// branch's, then the second's. The targets are those of the branch that they come from.
Gathered gather(const Branch& first, const Branch& second, const Branch& parent, float faintest);

// The list as textures, cut into pieces of at most `most_rays_a_piece`.
std::vector<Branch> upload_list(const RayList& list, int bounce);

inline constexpr std::size_t most_rays_a_piece = std::size_t{1} << 21;

} // namespace raysteps
