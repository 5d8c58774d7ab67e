#include "trace/trace_picture.h"

#include "basics/statistics.h"
#include "basics/text.h"
#include "image/heat_map.h"
#include "scene/ray_file.h"
#include "scene/scaling.h"
#include "structure/padding.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace raysteps {

namespace {

// From 0 to what 99 in 100 of the rays that did anything stay below: a few rays along a silhouette
// do many times more, and would leave the rest in the dark. The legend counts them.
HeatMapRange range_of_most(std::span<const float> values) {
    std::vector<float> some;
    std::copy_if(values.begin(), values.end(), std::back_inserter(some),
                 [](float value) { return value > 0.0f; });
    if (some.empty()) {
        return {};
    }
    return {.lower = 0.0f, .upper = static_cast<float>(summarize(some).percentile_99)};
}

} // namespace

Parts trace_parts(const std::string& triangle, const std::string& structure,
                  const std::string& view) {
    Parts parts = walk_parts(triangle, structure);
    if (is_heat_map(view)) {
        parts["observer"] = "observer/count.glsl";
    }
    return parts;
}

bool is_heat_map(const std::string& view) {
    return view == "visits" || view == "tests";
}

// Texels come bottom row first, a heat map wants the top one first.
Image show_work(const Texture& observations, const std::string& view,
                const std::string& structure) {
    const std::vector<glm::uvec4> texels = read_integers(observations);
    const int width = observations.width();
    const int height = observations.height();
    std::vector<float> values;
    values.reserve(texels.size());
    for (int row = height - 1; row >= 0; --row) {
        for (int column = 0; column < width; ++column) {
            const glm::uvec4& texel =
                texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)];
            values.push_back(static_cast<float>(view == "visits" ? texel.x : texel.y));
        }
    }
    const std::string title =
        view == "visits" ? ": cells or nodes visited a ray" : ": triangles tested a ray";
    return heat_map(values, width, height, range_of_most(values), structure + title);
}

FiguresHead head_of(const std::string& schema, const TraceOptions& tracing, const Scene& scene) {
    return {.schema = schema,
            .scenes = {record_of(scene)},
            .builders = {
                {tracing.structure, used_build_values(tracing.structure, tracing.build_values)}}};
}

Numbers numbers_of(const std::vector<Fact>& facts) {
    Numbers numbers = empty_object();
    for (const Fact& fact : facts) {
        numbers[fact.name] = fact.value;
    }
    return numbers;
}

void report_trace(const PictureOptions& picture, const TraceOptions& tracing, const Scene& scene,
                  const SceneTextures& textures, const TraceTime& time) {
    const auto [rays, seconds] = time;
    Numbers numbers{{"structure", tracing.structure},
                    {"triangle", tracing.triangle},
                    {"rays", static_cast<std::uint64_t>(rays)},
                    {"seconds", seconds},
                    {"million_rays_per_second", rays / seconds / 1e6},
                    {"facts", numbers_of(textures.structure.facts)}};
    std::printf("rays      %s in %.2f s: %s million per second\n", readable(rays).c_str(), seconds,
                readable(rays / seconds / 1e6).c_str());
    if (tracing.structure == "every_triangle") {
        const double tests = rays * textures.triangle_count;
        std::printf("tests     %s in %.2f s: %s million per second\n", readable(tests).c_str(),
                    seconds, readable(tests / seconds / 1e6).c_str());
        numbers["tests"] = static_cast<std::uint64_t>(tests);
        numbers["million_tests_per_second"] = tests / seconds / 1e6;
    }
    std::fflush(stdout);
    if (!picture.json.empty()) {
        write_figures(picture.json, head_of("trace.schema.json", tracing, scene), numbers);
    }
}

void trace_ray_file(const PictureOptions& picture, const TraceOptions& tracing,
                    const Scene& scene) {
    std::vector<Ray> rays =
        read_ray_file(tracing.rays, std::ldexp(1.0, -picture.scale_exponent) * scene.origin);
    for (Ray& ray : rays) {
        ray = scaled(ray, picture.scale_exponent);
    }
    const BuildRequest request{.reach = reach_of(rays, scene.corners),
                               .values = tracing.build_values};
    const std::string unusual =
        unusual_lengths(rays, tracing.rays,
                        usual_reach(bounds_of(scene.corners), static_cast<double>(request.reach)));
    if (!unusual.empty()) {
        print_warning(unusual);
    }
    const SceneTextures textures =
        upload(scene, build_structure(tracing.structure, scene.corners, request));
    TraceRays trace(trace_parts(tracing.triangle, tracing.structure), measure_limits());
    trace.report_progress(show_progress("tracing"));
    const RayTextures uploaded = upload_rays(rays);
    const auto [hits, seconds] = timed([&] { return trace.closest_hits(uploaded, textures); });
    write_hit_file(tracing.hits, read_hits(hits, rays.size()), scene);
    std::printf("wrote     %s, %zu hits\n", tracing.hits.string().c_str(), rays.size());
    report_trace(picture, tracing, scene, textures, {static_cast<double>(rays.size()), seconds});
}

} // namespace raysteps
