#pragma once

#include "image/image.h"
#include "render/trace_rays.h"
#include "scene/scene.h"

#include <vector>

namespace raysteps {

// How many rays of each kind a picture took.
struct RayCounts {
    long camera = 0;
    long shadow = 0; // hits that a light may reach, once per light
    long mirror = 0;
};

// A picture by Whitted's model with diffuse surfaces, hard shadows and mirrors, as a wavefront:
// each pass does one step of all paths. A path that has ended leaves the mask, and the passes end
// when no path is left, or when max_bounces mirrors have been followed; what lies behind those
// stays black. Source: Whitted, "An Improved Illumination Model for Shaded Display", 1980.
class WhittedRenderer {
public:
    // The textures are those of the scene, with the structure that the parts walk through.
    WhittedRenderer(const Scene& scene, SceneTextures textures, const Parts& trace_parts,
                    const Limits& limits);

    Image render(const Camera& camera, int width, int height, int max_bounces);

    // Of the last picture.
    const RayCounts& ray_counts() const { return counts_; }

    void report_progress(Progress progress) { trace_.report_progress(std::move(progress)); }

private:
    void add_lights(const RayTextures& rays, const Texture& hits, const Texture& weights,
                    const Texture& color, const LiveMask& live);

    std::vector<Light> lights_;
    glm::vec3 background_;
    SceneTextures scene_;
    TraceRays trace_;
    Program start_weights_;
    Program add_surroundings_;
    Program cast_shadow_rays_;
    Program add_light_;
    Program reflect_;
    Program select_misses_;
    Program select_unmirrored_;
    Program select_all_;
    RayCounts counts_;
};

} // namespace raysteps
