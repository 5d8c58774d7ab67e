#include "report/plot.h"

#include "error/error.h"
#include "file/write_file.h"

#include <sys/wait.h>

#include <cstdlib>
#include <sstream>

namespace raysteps {

namespace {

// For gnuplot and for the shell alike: neither looks into '...' until the next mark. Texts lose
// such marks; paths with one are refused.
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
           << "set grid\nset rmargin 6\nset key tmargin center horizontal\n"
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
    if (png.string().find_first_of("'\n") != std::string::npos) {
        throw InputError(png.string() + ": a plot's path cannot hold the mark ' or a line's end. "
                                        "Choose another --out.");
    }
    std::filesystem::path script = png;
    script.replace_extension(".gp");
    write_file(script, script_of(plot, png));
    const std::string command = "gnuplot " + quoted(std::filesystem::absolute(script).string());
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

} // namespace raysteps
