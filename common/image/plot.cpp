#include "image/plot.h"

#include "basics/error.h"
#include "basics/file.h"

#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace raysteps {

namespace {

std::string script_of(const Plot& plot, const std::filesystem::path& png) {
    std::ostringstream script;
    script.precision(9);
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        script << "$line" << i << " << END\n";
        for (const PlotPoint& point : plot.lines[i].points) {
            script << point.x << " " << point.y << "\n";
        }
        script << "END\n";
    }
    script << "set terminal pngcairo size 960,640 font 'DejaVu Sans,12' noenhanced\n"
           << "set output " << gnuplot_text(png.string()) << "\n"
           << "set title " << gnuplot_text(plot.title) << "\n"
           << "set xlabel " << gnuplot_text(plot.x_label) << "\n"
           << "set ylabel " << gnuplot_text(plot.y_label) << "\n"
           << "set grid\nset rmargin 6\nset key tmargin center horizontal\n"
           << (plot.x_scale == PlotScale::logarithmic ? "set logscale x\n" : "")
           << (plot.y_scale == PlotScale::logarithmic ? "set logscale y\n" : "") << "plot ";
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        script << (i == 0 ? "" : ", ") << "$line" << i
               << " using 1:2 with linespoints linewidth 2 pointtype " << i + 4 << " title "
               << gnuplot_text(plot.lines[i].name);
    }
    script << "\n";
    return script.str();
}

std::string script_of(const BarChart& chart, const std::filesystem::path& png) {
    std::ostringstream script;
    script.precision(9);
    script << "$bars << END\n";
    for (std::size_t i = 0; i < chart.labels.size(); ++i) {
        // Quotes would end the label, and a space would end the column.
        script << '"' << chart.labels[i] << '"';
        for (const BarSeries& series : chart.series) {
            const double value = series.values[i];
            script << " " << (std::isnan(value) ? std::string("?") : std::to_string(value));
        }
        script << "\n";
    }
    script << "END\n"
           << "set terminal pngcairo size 960,540 font 'DejaVu Sans,12' noenhanced\n"
           << "set output " << gnuplot_text(png.string()) << "\n"
           << "set title " << gnuplot_text(chart.title) << "\n"
           << "set ylabel " << gnuplot_text(chart.y_label) << "\n"
           << "set datafile missing '?'\nset style data histograms\n"
           << "set style histogram clustered gap 1\nset style fill solid 0.85 noborder\n"
           << "set grid ytics\nset yrange [0:*]\nset xtics rotate by -25 nomirror\n"
           << "set key tmargin center horizontal\nplot ";
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        script << (i == 0 ? "" : ", ") << "$bars using " << i + 2 << ":xtic(1) title "
               << gnuplot_text(chart.series[i].name);
    }
    script << "\n";
    return script.str();
}

} // namespace

std::string gnuplot_text(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        safe += letter == '\'' || letter == '\n' ? ' ' : letter;
    }
    return "'" + safe + "'";
}

void run_gnuplot(const std::filesystem::path& png, const std::string& script_text) {
    if (png.string().find_first_of("'\n") != std::string::npos) {
        throw InputError(png.string() +
                         ": the path of a plot cannot hold a quote ' or a line break. "
                         "Choose another --out.");
    }
    std::filesystem::path script = png;
    script.replace_extension(".gp");
    write_file(script, script_text);
    const std::string command =
        "gnuplot " + gnuplot_text(std::filesystem::absolute(script).string());
    // NOLINTNEXTLINE(cert-env33-c): the path is ours, and quoted
    const int status = std::system(command.c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
        throw MachineError(png.string() +
                           ": gnuplot is missing. Install the package gnuplot-nox, "
                           "or draw " +
                           script.string() + " elsewhere.");
    }
    if (status != 0) {
        throw MachineError(png.string() + ": gnuplot does not draw " + script.string() +
                           ", for the reason above.");
    }
}

void write_plot(const std::filesystem::path& png, const Plot& plot) {
    run_gnuplot(png, script_of(plot, png));
}

void write_bar_chart(const std::filesystem::path& png, const BarChart& chart) {
    run_gnuplot(png, script_of(chart, png));
}

} // namespace raysteps
