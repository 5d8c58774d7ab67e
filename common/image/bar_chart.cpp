#include "report/bar_chart.h"

#include "report/gnuplot.h"

#include <cmath>
#include <sstream>

namespace raysteps {

namespace {

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

void write_bar_chart(const std::filesystem::path& png, const BarChart& chart) {
    run_gnuplot(png, script_of(chart, png));
}

} // namespace raysteps
