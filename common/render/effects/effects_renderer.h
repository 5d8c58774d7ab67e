#pragma once

#include "gpu/program.h"
#include "image/image.h"
#include "render/effects/effect_buffers.h"
#include "render/effects/lamps.h"
#include "render/effects/plan.h"
#include "render/effects/ray_list.h"
#include "render/scene_textures.h"

#include <map>
#include <string>
#include <vector>

namespace raysteps {

// A picture of a scene with the effects of a plan, as a wavefront: each pass does one step of all
// paths. While a pixel has one path, its ray has the pixel's place. From the first glass on, where
// paths part in two, the rays of a bounce are a list without gaps, and each carries what it finds
// to its pixel; the next bounce's list has up to two for each of this one's. So Whitted's tree of
// rays is walked level by level.
// Source: Whitted, "An Improved Illumination Model for Shaded Display", 1980.
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

    // Of pictures that could not be read.
    const std::vector<std::string>& messages() const { return effects_.messages; }

    void report_progress(Progress progress) { progress_ = std::move(progress); }

private:
    RayTextures camera_rays(const Camera& camera, int width, int height, int sample);
    void follow(Branch branch, const Texture& color, int sample);
    void shade(Branch& branch, const Texture& hits, const Texture& light, int sample);
    void carry_to_pixels(const Branch& branch, const Texture& light, const Texture& color);
    bool mirror(Branch& branch, const Texture& hits);
    void part_at_glass(const Branch& branch, const Texture& hits);
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
