#include "11_paths/noise.h"

#include "basics/statistics.h"
#include "basics/text.h"
#include "basics/timed.h"
#include "image/plot.h"
#include "trace/trace_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace raysteps {

namespace {

struct Contender {
    std::string name;
    PathChoice choice;
    std::vector<PlotPoint> by_samples{}; // error over samples per pixel
    std::vector<PlotPoint> by_seconds{};
    double slope = 0.0; // of the logarithms: error ~ samples^slope
    double wanted_seconds = 0.0;
};

// All ideas together, and each of them taken away or changed by itself.
std::vector<Contender> contenders_of(const PathChoice& all) {
    const auto with = [&](const std::string& name, auto change) {
        Contender one{name, all};
        change(one.choice);
        return one;
    };
    return {with("all ideas", [](PathChoice&) {}),
            with("pcg numbers", [](PathChoice& one) { one.random = "pcg"; }),
            with("balance heuristic", [](PathChoice& one) { one.heuristic = "balance"; }),
            with("light_only", [](PathChoice& one) { one.heuristic = "light_only"; }),
            with("bounce_only", [](PathChoice& one) { one.heuristic = "bounce_only"; }),
            with("uniform bounces", [](PathChoice& one) { one.bounce = "uniform"; }),
            with("no roulette", [](PathChoice& one) { one.roulette = "none"; })};
}

class Measurement {
public:
    Measurement(const PictureOptions& picture, const TraceOptions& tracing, const Scene& scene)
        : picture_(picture), tracing_(tracing), scene_(scene), limits_(measure_limits()),
          built_(build_structure(
              tracing.structure, scene.corners,
              {.reach = camera_reach(picture, scene), .values = tracing.build_values})) {}

    PathRenderer renderer(const PathChoice& choice) const {
        return {scene_, upload(scene_, built_), choice,
                trace_parts(tracing_.triangle, tracing_.structure), limits_};
    }

    std::vector<glm::vec4> block(PathRenderer& renderer, int number) const {
        return renderer.render_block(scene_.camera, picture_.size.width, picture_.size.height,
                                     number);
    }

    PathSums empty() const {
        return PathSums({.width = picture_.size.width, .height = picture_.size.height});
    }

    PathSums reference(const PathChoice& choice, int samples) {
        PathChoice other = choice;
        ++other.seed;
        PathRenderer paths = renderer(other);
        const auto progress = show_progress("reference");
        PathSums sums = empty();
        sums.sees_lamp =
            paths.pixels_with_lamps(scene_.camera, picture_.size.width, picture_.size.height);
        const int blocks = std::max(2, samples / samples_per_block);
        for (int number = 0; number < blocks; ++number) {
            add_block(sums, number, block(paths, number));
            progress(static_cast<double>(number + 1) / blocks);
        }
        return sums;
    }

    // At each power of two of the blocks.
    void measure(Contender& contender, const Image& truth,
                 const std::vector<std::uint8_t>& left_out, int blocks) const {
        PathRenderer paths = renderer(contender.choice);
        block(paths, blocks); // the first one may compile, and is dropped
        PathSums sums = empty();
        double seconds = 0.0;
        for (int number = 0; number < blocks; ++number) {
            const auto [samples, taken] = timed([&] { return block(paths, number); });
            seconds += taken;
            add_block(sums, number, samples);
            const int count = number + 1;
            if ((count & (count - 1)) == 0) {
                const double error = relative_error(mean_of(sums), truth, left_out);
                contender.by_samples.push_back(
                    {static_cast<double>(samples_per_block * count), error});
                contender.by_seconds.push_back({seconds, error});
            }
        }
    }

private:
    const PictureOptions& picture_;
    const TraceOptions& tracing_;
    const Scene& scene_;
    Limits limits_;
    BuiltStructure built_;
};

double slope_of(const std::vector<PlotPoint>& points) {
    std::vector<GrowthPoint> growth;
    for (const PlotPoint& point : points) {
        growth.push_back({point.x, point.y});
    }
    return growth_exponent(growth);
}

void draw_noise(const std::filesystem::path& path, const std::string& scene,
                const std::vector<Contender>& contenders) {
    Plot plot{.title = "What noise costs: " + scene,
              .x_label = "seconds",
              .y_label = "root mean square error, % of the mean",
              .x_scale = PlotScale::logarithmic,
              .y_scale = PlotScale::logarithmic,
              .lines = {}};
    for (const Contender& one : contenders) {
        PlotLine line{one.name, one.by_seconds};
        for (PlotPoint& point : line.points) {
            point.y *= 100.0;
        }
        plot.lines.push_back(line);
    }
    write_plot(path, plot);
    print_written(path);
}

} // namespace

void add_noise_options(Options& options, NoiseRequest& request) {
    options.flag("--noise", request.measure,
                 "measure the error of each idea against its samples and seconds, up to --samples; "
                 "the advice is for the error of --error, or 0.02");
    options.number("--reference-samples", request.reference_samples,
                   "of the picture that --noise takes for the truth", 32, 1 << 20);
}

void measure_noise(const PictureOptions& picture, const TraceOptions& tracing,
                   const PathOptions& paths, const NoiseRequest& request, const Scene& scene) {
    const BlockRange range = blocks_of(paths.samples.empty() ? "256" : paths.samples);
    const int blocks = range.end - range.first;
    Measurement measurement(picture, tracing, scene);
    const PathSums reference = measurement.reference(paths.choice, request.reference_samples);
    const Image truth = mean_of(reference);
    std::cout << fmt::format("truth     {} samples per pixel, itself off by {} % of the mean\n",
                             samples_per_block * reference.block_count(),
                             readable(100.0 * estimated_error(reference)));
    std::vector<Contender> contenders = contenders_of(paths.choice);
    const double wanted = paths.error > 0.0 ? paths.error : request.wanted_error;
    std::cout << fmt::format("{:<18}{:>10}{:>10}{:>10}{:>16}\n", "", "error %", "seconds", "slope",
                             readable(100.0 * wanted) + " % takes, s");
    for (Contender& one : contenders) {
        measurement.measure(one, truth, reference.sees_lamp, blocks);
        one.slope = slope_of(one.by_samples);
        const PlotPoint& last = one.by_seconds.back();
        one.wanted_seconds = last.x * std::pow(last.y / wanted, -1.0 / one.slope);
        std::cout << fmt::format("{:<18}{:>10.2f}{:>10.2f}{:>10.2f}{:>16.1f}\n", one.name,
                                 100.0 * last.y, last.x, one.slope, one.wanted_seconds)
                  << std::flush;
    }
    const Contender& best = *std::ranges::min_element(contenders, {}, &Contender::wanted_seconds);
    std::cout << fmt::format("advice    for {} % take {}: about {} s\n", readable(100.0 * wanted),
                             best.name, readable(best.wanted_seconds));
    draw_noise(picture.out / "noise.png", scene.name, contenders);
}

} // namespace raysteps
