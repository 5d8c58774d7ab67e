#include "report/plot.h"

#include "report/gnuplot.h"

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

} // namespace

void write_plot(const std::filesystem::path& png, const Plot& plot) {
    run_gnuplot(png, script_of(plot, png));
}

} // namespace raysteps
