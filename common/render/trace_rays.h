#pragma once

#include "gpu/limits.h"
#include "gpu/live_mask.h"
#include "gpu/program.h"
#include "render/packets.h"
#include "render/rays.h"
#include "render/scene_textures.h"

#include <functional>
#include <optional>

namespace raysteps {

// Called while a long trace goes on, with the part that is done, 0 to 1.
using Progress = std::function<void(double part_done)>;

// The parts of a triangle test and of a structure by their names: a walk, `packet_NAME` or
// `fastest` (structure/structure.h). Throws InputError where there is no such part.
Parts walk_parts(const std::string& triangle, const std::string& structure);

// All names of structures that walk_parts takes.
std::vector<std::string> structure_names();

// The traversal and intersection kernel. A launch makes as many rounds as the platform's loops can
// bear, which ends most walks: an occlusion query counts them. Only where something is left, the
// kernel is launched as often as the longest walk needs, and keeps the hit and the position of each
// walk in textures, where the next launch takes them up; two sets of textures take turns. Source:
// Wang and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing", 2010.
class TraceRays {
public:
    // The parts fill the slots <triangle>, <structure> and <observer> of pass/trace/resume.frag;
    // where no observer is given nobody observes, and where no structure is given, it is
    // every_triangle. Where a part is given for the slot <packet>, it walks rays that are
    // neighbours in packets (pass/trace/trace_packets.frag), unless somebody observes, or counts in
    // another precision. The slot <cutout> is filled by what the scene of a trace calls for.
    TraceRays(Parts parts, const Limits& limits, Packets packets = Packets::where_faster);

    // For tests: launches of that many rounds, whatever the limits say.
    TraceRays(Parts parts, int rounds_per_launch, Packets packets = Packets::where_faster);

    // A texture of hits as core/hit_texels.glsl has them. Where a mask is given, only its live
    // pixels are asked for, and the others hold nothing of meaning. (A packet may trace their rays
    // too, so whoever makes neighbours under a mask leaves empty rays in the other pixels.)
    Texture closest_hits(const RayTextures& rays, const SceneTextures& scene,
                         const LiveMask* live = nullptr);
    Texture any_hits(const RayTextures& rays, const SceneTextures& scene,
                     const LiveMask* live = nullptr);

    // What the observer saw of the last trace: one texel per ray, as the file of the observer says.
    // Nothing where nobody observes.
    const std::optional<Texture>& observations() const { return observations_; }

    // How many launches the last trace took, and whether the first one was of packets.
    int launch_count() const { return launches_; }
    bool went_in_packets() const { return went_in_packets_; }

    void report_progress(Progress progress) { progress_ = std::move(progress); }

private:
    struct Request {
        const RayTextures& rays;
        const SceneTextures& scene;
        const LiveMask* live;
        float near_enough;
    };

    Texture trace(const Request& request);
    bool goes_in_packets(const Request& request);
    void choose_cutouts(const SceneTextures& scene);
    void set(Program& program, const Request& request) const;
    long count_asked(const Request& request);
    // Writes the hits of all walks that a single launch ends; says how many rays (of packets, how
    // many packets) are left.
    long trace_alone(const Request& request, const Texture& hits);
    long trace_packets(const Request& request, const Texture& hits);
    // The hits of all, whose walks have ended where there is one already.
    Texture resume(const Request& request, const Texture& hits);
    const LiveMask& everywhere(int width, int height);

    Parts parts_;
    int rounds_per_launch_;
    Packets packets_;
    bool observed_;
    // Compiled when they are needed first.
    std::optional<Program> trace_;
    std::optional<Program> trace_packets_;
    std::optional<Program> resume_;
    Program select_unfinished_{"pass/select/select_unfinished.frag"};
    Program select_all_{"pass/select/select_all.frag"};
    std::optional<Texture> observations_;
    std::optional<LiveMask> everywhere_;
    Texture nothing_{TexelFormat::rgba32ui, 1, 1}; // what the first launch is given as the last one
    int launches_ = 0;
    bool went_in_packets_ = false;
    Progress progress_ = [](double) {};
};

} // namespace raysteps
