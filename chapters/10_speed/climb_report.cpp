#include "climb_report.h"

#include "image/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace raysteps {

namespace {

const StepCosts* costs_of(const KindCosts& kind, const std::string& step) {
    const auto found = std::ranges::find_if(
        kind.steps, [&](const StepCosts& costs) { return costs.step == step; });
    return found == kind.steps.end() ? nullptr : &*found;
}

std::string range_words(const MeasuredRange& range) {
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", range.median, range.lowest, range.highest);
}

Numbers range_numbers(const MeasuredRange& range) {
    return {{"median", range.median}, {"lowest", range.lowest}, {"highest", range.highest}};
}

Numbers step_numbers(const StepCosts& costs) {
    Numbers numbers{{"step", costs.step},
                    {"ratio", range_numbers(costs.ratio)},
                    {"nanoseconds_per_ray", range_numbers(costs.nanoseconds)}};
    if (costs.lanes) {
        numbers["visits_per_ray"] = costs.visits_per_ray;
        numbers["tests_per_ray"] = costs.tests_per_ray;
        numbers["lanes_at_work"] = *costs.lanes;
    }
    return numbers;
}

Numbers kind_numbers(const KindCosts& kind) {
    Numbers steps = empty_list();
    for (const StepCosts& costs : kind.steps) {
        steps.push_back(step_numbers(costs));
    }
    return {{"kind", kind.kind},
            {"rays", kind.rays},
            {"yardstick_nanoseconds_per_ray", range_numbers(kind.yardstick)},
            {"steps", steps}};
}

// A block of lines for gnuplot: the step's place, the median, and both ends.
std::string data_of(const ClimbedScene& scene, const std::string& kind_name) {
    std::ostringstream data;
    for (const KindCosts& kind : scene.kinds) {
        if (kind.kind != kind_name) {
            continue;
        }
        const std::vector<SpeedStep> steps = speed_steps();
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (const StepCosts* const costs = costs_of(kind, steps[i].name)) {
                data << i << " " << costs->ratio.median << " " << costs->ratio.lowest << " "
                     << costs->ratio.highest << "\n";
            }
        }
    }
    return data.str();
}

double greatest_ratio(std::span<const ClimbedScene> scenes) {
    double greatest = 1.0;
    for (const ClimbedScene& scene : scenes) {
        for (const KindCosts& kind : scene.kinds) {
            for (const StepCosts& costs : kind.steps) {
                greatest = std::max(greatest, costs.ratio.highest);
            }
        }
    }
    return greatest;
}

// Of the scenes' lines: dark enough on paper, and apart for those who see fewer colours.
const std::vector<std::string> line_colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#5c4033"};

// So far are the marks of two scenes apart on an axis on which steps are 1 apart.
constexpr double between_scenes = 0.06;

std::string script_of(const std::filesystem::path& png, std::span<const ClimbedScene> scenes,
                      const std::string& yardstick) {
    const std::vector<std::string> kinds{"primary", "shadow", "bounce"};
    const std::vector<SpeedStep> steps = speed_steps();
    std::ostringstream script;
    for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
        for (const std::string& kind : kinds) {
            script << "$" << kind << scene << " << END\n"
                   << data_of(scenes[scene], kind) << "END\n";
        }
    }
    script << "set terminal pngcairo size 1080,500 font 'DejaVu Sans,12' noenhanced\n"
           << "set output " << gnuplot_text(png.string()) << "\n"
           << "set multiplot layout 1,3 margins 0.07,0.99,0.25,0.84 spacing 0.03\n"
           << "set label 1 "
           << gnuplot_text("Rays a second over those of " + yardstick +
                           ": the median of all rounds, and their range")
           << " at screen 0.5,0.96 center font 'DejaVu Sans,14'\n"
           << "set grid ytics\nset xrange [-0.4:" << steps.size() - 0.6
           << "]\nset yrange [0:" << 1.08 * greatest_ratio(scenes)
           << "]\nset xtics rotate by 35 right nomirror (";
    for (std::size_t i = 0; i < steps.size(); ++i) {
        script << (i == 0 ? "" : ", ") << gnuplot_text(steps[i].name) << " " << i;
    }
    script << ")\nset key off\n";
    for (const std::string& kind : kinds) {
        script << "set title " << gnuplot_text(kind + " rays") << "\n";
        if (kind == kinds.back()) {
            script << "set key top right opaque\n";
        }
        script << "plot 1 with lines lw 2 dt 2 lc rgb '#555555' notitle";
        for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
            const double shift = between_scenes * (static_cast<double>(scene) -
                                                   static_cast<double>(scenes.size() - 1) / 2.0);
            const std::string color = gnuplot_text(line_colors[scene % line_colors.size()]);
            const std::string block = "$" + kind + std::to_string(scene);
            script << ", " << block << " using ($1+" << shift << "):2 with lines lw 2 lc rgb "
                   << color << " notitle, " << block << " using ($1+" << shift
                   << "):2:3:4 with yerrorbars lw 2 pt 7 ps 1.1 lc rgb " << color << " title "
                   << gnuplot_text(scenes[scene].scene);
        }
        script << "\nunset label 1\nset format y ''\n";
    }
    script << "unset multiplot\n";
    return script.str();
}

} // namespace

std::string to_table(const ClimbedScene& scene, const std::string& yardstick) {
    std::string table = fmt::format("\n{}, {} triangles: rays a second over those of {}, by "
                                    "processor time (range of the rounds)\n{:16}",
                                    scene.scene, scene.triangles, yardstick, "step");
    for (const KindCosts& kind : scene.kinds) {
        table += fmt::format("  {:22}", kind.kind);
    }
    for (const SpeedStep& step : speed_steps()) {
        table += fmt::format("\n{:16}", step.name);
        for (const KindCosts& kind : scene.kinds) {
            const StepCosts* const costs = costs_of(kind, step.name);
            table += fmt::format("  {:22}", costs != nullptr ? range_words(costs->ratio)
                                                             : "as the step before");
        }
    }
    table += "\nrays       step             ns a ray  visits   tests  lanes at work\n";
    for (const KindCosts& kind : scene.kinds) {
        table += fmt::format("{:10} {:16} {:8.1f}\n", kind.kind, yardstick, kind.yardstick.median);
        for (const StepCosts& costs : kind.steps) {
            table +=
                fmt::format("{:10} {:16} {:8.1f}", kind.kind, costs.step, costs.nanoseconds.median);
            table += costs.lanes ? fmt::format(" {:7.1f} {:7.2f}  {:.2f}\n", costs.visits_per_ray,
                                               costs.tests_per_ray, *costs.lanes)
                                 : "       -       -  -\n";
        }
    }
    return table;
}

Numbers to_numbers(std::span<const ClimbedScene> scenes, const ClimbRequest& request) {
    Numbers list = empty_list();
    for (const ClimbedScene& scene : scenes) {
        Numbers kinds = empty_list();
        for (const KindCosts& kind : scene.kinds) {
            kinds.push_back(kind_numbers(kind));
        }
        list.push_back({{"scene", scene.scene}, {"kinds", kinds}});
    }
    return {{"width", request.width},
            {"height", request.height},
            {"rounds", request.rounds},
            {"embree", request.embree == EmbreePart::none ? "" : embree_name()},
            {"yardstick", yardstick_of(request)},
            {"scenes", list}};
}

void draw_climb(const std::filesystem::path& png, std::span<const ClimbedScene> scenes,
                const std::string& yardstick) {
    run_gnuplot(png, script_of(png, scenes, yardstick));
}

void draw_lanes(const std::filesystem::path& png, const ClimbedScene& scene) {
    BarChart chart{.title = "Lanes at work, of eight: " + scene.scene,
                   .y_label = "visits of all rays / 8 x those of the slowest",
                   .labels = {},
                   .series = {}};
    for (const SpeedStep& step : speed_steps()) {
        if (!has_packets(step.structure)) {
            chart.labels.push_back(step.name);
        }
    }
    for (const KindCosts& kind : scene.kinds) {
        BarSeries series{kind.kind, {}};
        for (const std::string& label : chart.labels) {
            const StepCosts* const costs = costs_of(kind, label);
            series.values.push_back(costs != nullptr && costs->lanes
                                        ? *costs->lanes
                                        : std::numeric_limits<double>::quiet_NaN());
        }
        chart.series.push_back(std::move(series));
    }
    write_bar_chart(png, chart);
}

} // namespace raysteps
