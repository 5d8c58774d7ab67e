#include "plot_resolution.h"

#include "basics/error.h"
#include "image/plot.h"
#include "measure/measure_structures.h"
#include "trace/measure_walks.h"
#include "trace/trace_picture.h"

namespace raysteps {

namespace {

// Few cells mean long lists: a big scene would take minutes to show what everybody knows.
constexpr double most_triangles_a_cell = 3000.0;

const std::vector<int> resolutions{1, 2, 4, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};

} // namespace

void plot_resolution(const PictureOptions& picture, const TraceOptions& tracing,
                     const Scene& scene) {
    check_build_values(tracing.build_values, {{tracing.structure}});
    if (family_of(tracing.structure).name != "grid") {
        throw InputError("--structure " + tracing.structure +
                         ": --plot is about grids. Take grid or grid_mailbox.");
    }
    PlotLine visits{"cells visited", {}};
    PlotLine tests{"triangles tested", {}};
    PlotLine time{"time in ns", {}};
    Numbers numbers = empty_list();
    const Limits limits = measure_limits();
    const auto progress = show_progress("resolutions");
    double done = 0.0;
    for (const int resolution : resolutions) {
        progress(done++ / static_cast<double>(resolutions.size()));
        if (triangle_count(scene) / static_cast<double>(resolution * resolution) >
            most_triangles_a_cell) {
            continue;
        }
        MeasureRequest request{.structures = plain_structures({tracing.structure}),
                               .build_values = tracing.build_values,
                               .triangle = tracing.triangle,
                               .kinds = {"primary"},
                               .width = picture.size.width,
                               .height = picture.size.height};
        request.build_values["resolution"] = std::to_string(resolution);
        StructureContest contest(request, limits);
        const SceneCosts costs = measure_or_dispute(
            contest, scene, [](double) {}, picture.out);
        const RayCosts& primary = costs.rays.front();
        visits.points.push_back({static_cast<double>(resolution), primary.visits_per_ray});
        tests.points.push_back({static_cast<double>(resolution), primary.tests_per_ray});
        time.points.push_back({static_cast<double>(resolution), 1000.0 / primary.rate.median});
        numbers.push_back({{"resolution", resolution},
                           {"visits_per_ray", primary.visits_per_ray},
                           {"tests_per_ray", primary.tests_per_ray},
                           {"million_rays_per_second", primary.rate.median},
                           {"lowest", primary.rate.lowest},
                           {"highest", primary.rate.highest}});
    }
    progress(1.0);
    const std::filesystem::path path =
        picture.out / (picture_name(picture.scene) + "_resolution.png");
    write_plot(path, {.title = "A grid over " + scene.name + ": what a ray costs",
                      .x_label = "cells along the longest side",
                      .y_label = "a ray",
                      .x_scale = PlotScale::logarithmic,
                      .y_scale = PlotScale::logarithmic,
                      .lines = {visits, tests, time}});
    print_written(path);
    write_figures(picture.json, head_of("resolutions.schema.json", tracing, scene),
                  {{"structure", tracing.structure},
                   {"triangle", tracing.triangle},
                   {"resolutions", numbers}});
}

} // namespace raysteps
