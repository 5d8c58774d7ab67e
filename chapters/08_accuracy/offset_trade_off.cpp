#include "basics/text.h"
#include "trade_offs.h"

#include "basics/random_numbers.h"
#include "gpu/draw.h"
#include "gpu/gl.h"
#include "gpu/shaders.h"
#include "render/scene_textures.h"
#include "render/trace_rays.h"
#include "scene/mesh.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <memory>

namespace raysteps {

namespace {

constexpr int divisions = 4; // 320 triangles

// A sphere with a shell around it, and points on the sphere with directions to leave it.
struct Shells {
    std::string name;
    float radius = 1.0f;
    glm::vec3 center{0.0f};
    float gap = 4e-5f; // in radii

    Scene scene{};
    int inner_triangles = 0;
    std::vector<Hit> points{};
    std::vector<glm::vec4> directions{};
};

Shells with_points(Shells shells, const Effort& effort) {
    const Mesh inner = sphere(shells.center, shells.radius, divisions);
    const Mesh outer = sphere(shells.center, shells.radius * (1.0f + shells.gap), divisions);
    shells.scene = add_mesh({}, join(inner, outer), Material{});
    shells.inner_triangles = static_cast<int>(inner.corners.size() / 3);
    RandomNumbers numbers(effort.seed);
    for (std::size_t i = 0; i < effort.judged_rays; ++i) {
        Hit hit{0.0f, numbers.unit(), numbers.unit(), numbers.below(shells.inner_triangles)};
        if (hit.u + hit.v > 1.0f) {
            hit.u = 1.0f - hit.u;
            hit.v = 1.0f - hit.v;
        }
        const auto first = 3 * static_cast<std::size_t>(hit.triangle);
        const glm::vec3 a = inner.corners[first];
        const glm::vec3 normal =
            glm::cross(inner.corners[first + 1] - a, inner.corners[first + 2] - a);
        const glm::vec3 any = numbers.in_cube();
        shells.points.push_back(hit);
        shells.directions.emplace_back(glm::dot(any, normal) < 0.0f ? -any : any, 0.0f);
    }
    return shells;
}

// Texels in rows of a width that divides the number of rays, so that none is left over.
constexpr int row = 1024;

Texture upload_points(std::span<const Hit> points) {
    std::vector<glm::uvec4> texels;
    for (const Hit& hit : points) {
        texels.emplace_back(0U, std::bit_cast<std::uint32_t>(hit.u),
                            std::bit_cast<std::uint32_t>(hit.v),
                            static_cast<std::uint32_t>(hit.triangle));
    }
    Texture texture(TexelFormat::rgba32ui, row, static_cast<int>(points.size()) / row,
                    TexelLayout::one_layer);
    write_texels(texture, texels);
    return texture;
}

Texture upload_directions(std::span<const glm::vec4> directions) {
    Texture texture(TexelFormat::rgba32f, row, static_cast<int>(directions.size()) / row);
    write_texels(texture, directions);
    return texture;
}

// What all methods of a family share.
struct ShellTextures {
    Shells shells;
    SceneTextures scene;
    Texture points;
    Texture directions;
};

std::shared_ptr<const ShellTextures> upload_shells(Shells shells) {
    SceneTextures scene = upload(shells.scene);
    Texture points = upload_points(shells.points);
    Texture directions = upload_directions(shells.directions);
    return std::make_shared<const ShellTextures>(ShellTextures{
        std::move(shells), std::move(scene), std::move(points), std::move(directions)});
}

class LeaveSurfaces {
public:
    LeaveSurfaces(const std::string& part, std::shared_ptr<const ShellTextures> from)
        : from_(std::move(from)), program_("pass/rays/leave_surfaces.frag", {{"offset", part}}),
          rays_(make_ray_textures(from_->points.width(), from_->points.height())) {
        program_.set("hits", from_->points)
            .set("leaving_directions", from_->directions)
            .set("triangle_corners", from_->scene.corners);
    }

    void run() {
        draw(program_, {.textures = {rays_.origins, rays_.directions}});
        glFinish();
    }
    const RayTextures& rays() const { return rays_; }

private:
    std::shared_ptr<const ShellTextures> from_;
    Program program_;
    RayTextures rays_;
};

glm::dvec3 exact_point(const Shells& shells, const Hit& hit) {
    const auto first = 3 * static_cast<std::size_t>(hit.triangle);
    const glm::dvec3 a(shells.scene.corners[first]);
    const glm::dvec3 b(shells.scene.corners[first + 1]);
    const glm::dvec3 c(shells.scene.corners[first + 2]);
    return a + static_cast<double>(hit.u) * (b - a) + static_cast<double>(hit.v) * (c - a);
}

Findings judge_leaving(const Shells& shells, std::span<const Ray> rays, std::span<const Hit> hits) {
    Fault acne{"acne", 0, rays.size()};
    Fault leak{"leaked", 0, rays.size()};
    std::vector<float> moved;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        acne.count += hits[i].triangle >= 0 && hits[i].triangle < shells.inner_triangles ? 1 : 0;
        leak.count += hits[i].triangle < 0 ? 1 : 0;
        const glm::dvec3 shift = glm::dvec3(rays[i].origin) - exact_point(shells, shells.points[i]);
        moved.push_back(
            static_cast<float>(glm::length(shift) / static_cast<double>(shells.radius)));
    }
    return {{acne, leak}, summarize(moved), {}};
}

} // namespace

TradeOffTrials offset_trade_off(const Effort& effort) {
    Effort whole_rows = effort;
    whole_rows.judged_rays = std::max<std::size_t>(effort.judged_rays / row, 1) * row;
    TradeOffTrials trade_off;
    trade_off.name = "offset";
    trade_off.question = "How does a ray get off the surface that it starts on?";
    trade_off.unit_of_cases = "ray";
    trade_off.unit_of_error = "origin moved, in radii";
    const auto trace =
        std::make_shared<TraceRays>(Parts{{"triangle", "triangle/watertight.glsl"}}, effort.limits);
    for (const Shells& shells :
         {Shells{"radius 1", 1.0f, {}, 4e-5f}, Shells{"radius 0.001", 1e-3f, {}, 4e-5f},
          Shells{"radius 1000", 1e3f, {}, 4e-5f},
          Shells{"radius 1, 1000 from zero", 1.0f, {1000.0f, 1000.0f, 1000.0f}, 1e-2f}}) {
        const auto from = upload_shells(with_points(shells, whole_rows));
        for (const NamedPart& part : list_parts("offset")) {
            const auto leave = std::make_shared<LeaveSurfaces>(part.file, from);
            trade_off.trials.push_back(
                {.method = spoken(part.name),
                 .family = shells.name,
                 .timed_cases = from->shells.points.size(),
                 .run = [leave] { leave->run(); },
                 .examine =
                     [leave, trace, from] {
                         leave->run();
                         const Texture hits = trace->closest_hits(leave->rays(), from->scene);
                         return judge_leaving(from->shells, read_rays(leave->rays()),
                                              read_hits(hits));
                     }});
        }
    }
    return trade_off;
}

} // namespace raysteps
