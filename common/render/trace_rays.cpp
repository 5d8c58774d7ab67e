#include "render/trace_rays.h"

#include "basics/error.h"
#include "basics/text.h"
#include "gpu/draw.h"
#include "structure/structure.h"

#include <algorithm>
#include <filesystem>
#include <limits>

namespace raysteps {

namespace {

// About a second of work for 512 x 512 rays on a small processor: progress can be shown, and no
// watchdog of a GPU's driver wakes up.
constexpr int usual_rounds_per_launch = 2048;

// The rays that a processor runs side by side may share one loop budget (Mesa's llvmpipe: 8 or 16
// rays), and each makes its rounds while the others wait.
constexpr int rays_side_by_side = 16;

// This many launches in which no ray comes to its end mean that a walk is stuck. (A cell or leaf
// would have to list eight million triangles to need as many.)
constexpr int most_launches_in_vain = 1 << 12;

constexpr float farthest = std::numeric_limits<float>::max();

const std::string nobody = "observer/none.glsl";
const std::string no_cutouts = "cutout/none.glsl";
const std::string trace_pass = "pass/trace/trace.frag";
const std::string packets_pass = "pass/trace/trace_packets.frag";
const std::string resume_pass = "pass/trace/resume.frag";

// A packet costs as much for one ray as for four, and one without any costs its fetches, while rays
// by themselves cost nothing where the mask has none. So packets are for masks of which at least
// one pixel in so many is live.
constexpr long least_part_asked = 4;

bool can_go_in_packets(const Parts& parts) {
    const auto precision = parts.find("real");
    return parts.contains("packet") && parts.at("observer") == nobody &&
           (precision == parts.end() || precision->second == "real/float.glsl");
}

long pixel_count(const RayTextures& rays) {
    return static_cast<long>(rays.origins.width()) * rays.origins.height();
}

Parts with_defaults(Parts parts) {
    parts.try_emplace("structure", "structure/every_triangle.glsl");
    parts.try_emplace("observer", nobody);
    parts.try_emplace("cutout", no_cutouts);
    return parts;
}

// What a hit texel holds until the walk of its ray has ended: core/walk.glsl, `unfinished_walk`.
constexpr glm::uvec4 unfinished_hit{0u, 0u, 0u, static_cast<unsigned>(-2)};

// What a launch leaves of each walk.
struct WalkTextures {
    Texture hits;
    Texture places;
    std::optional<Texture> observations;

    std::vector<std::reference_wrapper<const Texture>> targets() const {
        std::vector<std::reference_wrapper<const Texture>> all{hits, places};
        if (observations) {
            all.emplace_back(*observations);
        }
        return all;
    }
};

WalkTextures make_walk_textures(int width, int height, bool observed) {
    WalkTextures textures{Texture(TexelFormat::rgba32ui, width, height, TexelLayout::one_layer),
                          Texture(TexelFormat::rgba32ui, width, height),
                          {}};
    if (observed) {
        textures.observations.emplace(TexelFormat::rgba32ui, width, height);
    }
    return textures;
}

} // namespace

Parts walk_parts(const std::string& triangle, const std::string& structure) {
    const std::vector<std::string> names = structure_names();
    if (std::ranges::find(names, structure) == names.end()) {
        throw InputError(
            no_such_choice("--structure", structure, "structure", {names.begin(), names.end()}));
    }
    Parts parts{{"triangle", find_part("triangle", triangle)},
                {"structure", find_part("structure", single_walk(structure))}};
    if (has_packets(structure)) {
        parts["packet"] = find_part("packet", "packet_" + single_walk(structure));
    }
    return parts;
}

std::vector<std::string> structure_names() {
    std::vector<std::string> names{"fastest"};
    for (const char* slot : {"structure", "packet"}) {
        for (const NamedPart& part : list_parts(slot)) {
            names.push_back(part.name);
        }
    }
    std::ranges::sort(names);
    return names;
}

TraceRays::TraceRays(Parts parts, const Limits& limits, Packets packets)
    : TraceRays(std::move(parts),
                std::min(usual_rounds_per_launch, limits.loop_budget / rays_side_by_side),
                packets) {}

TraceRays::TraceRays(Parts parts, int rounds_per_launch, Packets packets)
    : parts_(with_defaults(std::move(parts))), rounds_per_launch_(rounds_per_launch),
      packets_(can_go_in_packets(parts_) ? packets : Packets::never),
      observed_(parts_.at("observer") != nobody) {
    std::optional<Program>& first = observed_ ? resume_ : trace_;
    first.emplace(observed_ ? resume_pass : trace_pass, parts_);
}

Texture TraceRays::closest_hits(const RayTextures& rays, const SceneTextures& scene,
                                const LiveMask* live) {
    return trace({rays, scene, live, -farthest});
}

Texture TraceRays::any_hits(const RayTextures& rays, const SceneTextures& scene,
                            const LiveMask* live) {
    return trace({rays, scene, live, farthest});
}

Texture TraceRays::trace(const Request& request) {
    const int width = request.rays.origins.width();
    const int height = request.rays.origins.height();
    launches_ = 0;
    went_in_packets_ = false;
    choose_cutouts(request.scene);
    // Walks that a launch is known to cut are not begun in vain.
    if (observed_ || request.scene.structure.longest_walk > rounds_per_launch_) {
        const Texture nothing(TexelFormat::rgba32ui, width, height, TexelLayout::one_layer);
        clear(nothing, unfinished_hit);
        return resume(request, nothing);
    }
    went_in_packets_ = goes_in_packets(request);
    Texture hits(TexelFormat::rgba32ui, width, height,
                 went_in_packets_ ? TexelLayout::quads : TexelLayout::one_layer);
    const long left = went_in_packets_ ? trace_packets(request, hits) : trace_alone(request, hits);
    launches_ = 1;
    if (left > 0) {
        return resume(request, hits);
    }
    progress_(1.0);
    return hits;
}

bool TraceRays::goes_in_packets(const Request& request) {
    if (packets_ == Packets::never || request.rays.coherence == Coherence::alone) {
        return false;
    }
    if (packets_ == Packets::always) {
        return true;
    }
    const long asked = count_asked(request);
    if (asked < least_rays_for_packets() || asked * least_part_asked < pixel_count(request.rays)) {
        return false;
    }
    const std::string structure = std::filesystem::path(parts_.at("packet")).stem();
    const bool are_faster = packets_are_faster(
        structure, [this](const RayTextures& rays, const SceneTextures& scene, Packets packets) {
            choose_cutouts(scene);
            const bool together = packets == Packets::always;
            const Texture hits(TexelFormat::rgba32ui, rays.origins.width(), rays.origins.height(),
                               together ? TexelLayout::quads : TexelLayout::one_layer);
            const Request batch{rays, scene, nullptr, -farthest};
            together ? trace_packets(batch, hits) : trace_alone(batch, hits);
        });
    choose_cutouts(request.scene);
    return are_faster;
}

// Only a scene with holes in its surfaces has programs that ask for them.
void TraceRays::choose_cutouts(const SceneTextures& scene) {
    const std::string part = scene.cutouts.empty() ? no_cutouts : "cutout/pictures.glsl";
    if (parts_.at("cutout") != part) {
        parts_["cutout"] = part;
        trace_.reset();
        trace_packets_.reset();
        resume_.reset();
    }
}

void TraceRays::set(Program& program, const Request& request) const {
    program.set("ray_origins", request.rays.origins)
        .set("ray_directions", request.rays.directions)
        .set("triangle_corners", request.scene.corners)
        .set("near_enough", request.near_enough)
        .set("rounds", rounds_per_launch_);
    bind(program, request.scene.structure);
    for (const auto& [name, buffer] : request.scene.cutouts) {
        program.set(name, buffer);
    }
}

long TraceRays::count_asked(const Request& request) {
    return request.live ? count_live(*request.live, select_all_) : pixel_count(request.rays);
}

long TraceRays::trace_alone(const Request& request, const Texture& hits) {
    if (!trace_) {
        trace_.emplace(trace_pass, parts_);
    }
    set(*trace_, request);
    const long ended = draw_and_count(
        *trace_, {.textures = {hits}, .live = request.live, .clear_to = unfinished_hit});
    return count_asked(request) - ended;
}

long TraceRays::trace_packets(const Request& request, const Texture& hits) {
    if (!trace_packets_) {
        trace_packets_.emplace(packets_pass, parts_);
    }
    set(*trace_packets_, request);
    const long ended =
        draw_and_count(*trace_packets_, {.textures = {hits}, .clear_to = unfinished_hit});
    return static_cast<long>(hits.layer_width()) * hits.layer_height() - ended;
}

const LiveMask& TraceRays::everywhere(int width, int height) {
    if (!everywhere_ || everywhere_->width() != width || everywhere_->height() != height) {
        everywhere_.emplace(width, height);
    }
    return *everywhere_;
}

Texture TraceRays::resume(const Request& request, const Texture& hits) {
    const int width = hits.width();
    const int height = hits.height();
    if (!resume_) {
        resume_.emplace(resume_pass, parts_);
    }
    set(*resume_, request);
    std::optional<WalkTextures> last;
    WalkTextures next = make_walk_textures(width, height, observed_);
    const LiveMask& asked = request.live ? *request.live : everywhere(width, height);
    const int longest_walk = request.scene.structure.longest_walk;
    const double ray_count = static_cast<double>(width) * height;
    long last_unfinished = -1;
    for (int in_vain = 0; in_vain <= most_launches_in_vain + longest_walk / rounds_per_launch_;) {
        resume_->set("first_launch", last ? 0 : 1)
            .set("last_hits", last ? last->hits : hits)
            .set("last_places", last ? last->places : nothing_)
            .set("last_observations", last && observed_ ? *last->observations : nothing_);
        draw(*resume_, {.textures = next.targets(), .live = request.live});
        ++launches_;
        select_unfinished_.set("places", next.places);
        const long unfinished = count_live(asked, select_unfinished_);
        if (unfinished == 0) {
            progress_(1.0);
            observations_ = std::move(next.observations);
            return std::move(next.hits);
        }
        if (!last) {
            last = make_walk_textures(width, height, observed_);
        }
        std::swap(*last, next);
        in_vain = unfinished == last_unfinished ? in_vain + 1 : 0;
        last_unfinished = unfinished;
        const double rounds = static_cast<double>(launches_) * rounds_per_launch_;
        progress_(longest_walk > 0 ? rounds / longest_walk
                                   : 1.0 - static_cast<double>(unfinished) / ray_count);
    }
    throw MachineError("The walk of " + std::to_string(last_unfinished) +
                       " rays stands still after " + std::to_string(launches_) +
                       " launches. If a shader was edited, look there; else update the driver, or "
                       "try --context osmesa.");
}

} // namespace raysteps
