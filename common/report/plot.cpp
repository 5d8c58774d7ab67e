#include "report/plot.h"

#include "error/error.h"
#include "file/write_file.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace raysteps {

namespace {

// In the quotes of gnuplot and of the shell alike, '' within '...' is no end only for gnuplot, so
// the name of a file with such a mark is refused rather than guessed at.
std::string quoted(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        safe += letter == '\'' || letter == '\n' ? ' ' : letter;
    }
    return "'" + safe + "'";
}

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
           << "set output " << quoted(png.string()) << "\n"
           << "set title " << quoted(plot.title) << "\n"
           << "set xlabel " << quoted(plot.x_label) << "\n"
           << "set ylabel " << quoted(plot.y_label) << "\n"
           << "set grid\nset key tmargin center horizontal\n"
           << (plot.x_scale == PlotScale::logarithmic ? "set logscale x\n" : "")
           << (plot.y_scale == PlotScale::logarithmic ? "set logscale y\n" : "") << "plot ";
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        script << (i == 0 ? "" : ", ") << "$line" << i
               << " using 1:2 with linespoints linewidth 2 pointtype " << i + 4 << " title "
               << quoted(plot.lines[i].name);
    }
    script << "\n";
    return script.str();
}

} // namespace

void write_plot(const std::filesystem::path& png, const Plot& plot) {
    if (png.string().find('\'') != std::string::npos) {
        throw InputError(png.string() + ": a plot's path cannot hold the mark '. Choose another.");
    }
    std::filesystem::path script = png;
    script.replace_extension(".gp");
    write_file(script, script_of(plot, png));
    // NOLINTNEXTLINE(cert-env33-c): the path is ours, and quoted
    if (std::system(("gnuplot " + quoted(script.string())).c_str()) != 0) {
        throw MachineError(png.string() +
                           ": gnuplot does not draw the plot. Install gnuplot (the package "
                           "gnuplot-nox), or draw " +
                           script.string() + " elsewhere.");
    }
}

} // namespace raysteps
