#include "page.h"

#include "base64.h"
#include "basics/text.h"
#include "page_plots.h"
#include "scatter_plot.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

namespace {

const char* const style = R"(<style>
body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; margin: 2em auto; max-width: 66em;
       padding: 0 1em; color: #1b1b1b; background: #fff; }
h1, h2 { line-height: 1.2; } h2 { margin-top: 2.2em; border-top: 2px solid #ddd; padding-top: .8em; }
table { border-collapse: collapse; font-size: 14px; margin: 1em 0; }
th, td { padding: .22em .7em; text-align: right; border-bottom: 1px solid #e4e4e4; }
th:first-child, td:first-child { text-align: left; } tr.family th { text-align: left;
       background: #f2f2f2; } td.bad { color: #a30000; } td.good { color: #00601b; }
td.left, .words th { text-align: left; }
.plot { width: 100%; max-width: 860px; display: block; margin: .6em 0; }
.plot text { font: 13px "DejaVu Sans", Verdana, sans-serif; fill: #222; }
.plot .title { font-weight: bold; font-size: 15px; } .plot .middle { text-anchor: middle; }
.plot .end { text-anchor: end; } .plot .tick { font-size: 11.5px; fill: #555; }
.plot .grid { stroke: #e8e8e8; } .plot .frame { fill: none; stroke: #999; }
.plot .range { stroke-width: 1.6; } .plot .leader { fill: none; stroke: #bbb; stroke-width: .8; }
.plot .best .mark, .plot .best .range { fill: #0b5fa5; stroke: #0b5fa5; }
.plot .dominated .mark { fill: #fff; stroke: #9a9a9a; stroke-width: 1.6; }
.plot .dominated .range { stroke: #b4b4b4; } .plot .dominated .label { fill: #777; }
.plot g:hover .mark { fill: #d95f02; } .plot g:hover .leader { stroke: #d95f02; stroke-width: 1.6; }
.pictures { display: flex; flex-wrap: wrap; gap: 14px; } figure { margin: 0; width: 192px; }
figure img { width: 192px; image-rendering: pixelated; border: 1px solid #ccc; }
figcaption { font-size: 13px; line-height: 1.3; } .note { color: #555; font-size: 14px; }
</style>
)";

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : "; ") + word;
    }
    return text;
}

std::string advice_table(const std::vector<Advice>& advice) {
    std::string html = "<table class='words'><tr><th>choice</th><th>need</th><th>it must have</th>"
                       "<th>take (no rank among those named together)</th></tr>\n";
    for (const Advice& one : advice) {
        html += "<tr><td>" + escaped(one.knob) + "</td><td class='left'>" + escaped(one.need) +
                "</td><td class='left'>" + escaped(one.condition) + "</td><td class='left'>" +
                (one.methods.empty() ? "<em>none of these</em>" : escaped(join(one.methods))) +
                "</td></tr>\n";
    }
    return html + "</table>\n";
}

std::string fault_cells(const Findings& findings, std::size_t columns) {
    std::string html;
    for (const Fault& fault : findings.faults) {
        html += fmt::format("<td class='{}'>", fault.count == 0 ? "good" : "bad") +
                escaped(to_string(fault_rate(fault.count, fault.of))) +
                fmt::format("</td><td>{} of {}</td>", fault.count, fault.of);
    }
    for (std::size_t i = findings.faults.size(); i < columns; ++i) {
        html += "<td></td><td></td>";
    }
    return html;
}

// The names of the faults that all measurements of a knob have, or of its first that has any; those
// of families that count another thing stand in their own line.
std::vector<std::string> fault_names(const KnobResult& result, const std::string& family) {
    std::vector<std::string> names;
    for (const Measurement& one : result.measurements) {
        if (one.family == family && names.empty()) {
            for (const Fault& fault : one.findings.faults) {
                names.push_back(fault.name);
            }
        }
    }
    return names;
}

std::string measures_cell(const Findings& findings) {
    std::string text;
    for (const Measure& measure : findings.measures) {
        text += (text.empty() ? "" : ", ") + measure.name + fmt::format(" {:.5g}", measure.value);
    }
    return "<td class='left'>" + escaped(text) + "</td>";
}

std::string measurement_row(const KnobResult& result, const Measurement& one, std::size_t columns) {
    std::string html = "<tr><td>" + escaped(one.method) + "</td>" +
                       fmt::format("<td>{:.4g}</td><td>{:.4g} to {:.4g}</td>", one.cost.median,
                                   one.cost.lowest, one.cost.highest) +
                       fault_cells(one.findings, columns);
    if (!result.unit_of_error.empty()) {
        const auto& error = one.findings.error;
        html += error ? fmt::format("<td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td>", error->median,
                                    error->percentile_99, error->largest)
                      : "<td></td><td></td><td></td>";
    }
    return html + measures_cell(one.findings) + "</tr>\n";
}

std::string measurement_table(const KnobResult& result) {
    std::size_t columns = 0;
    for (const Measurement& one : result.measurements) {
        columns = std::max(columns, one.findings.faults.size());
    }
    std::string html = "<table>\n";
    for (const std::string& family : families_of(result)) {
        html += "<tr class='family'><th>" + escaped(family) + "</th><th>ns a " +
                escaped(result.unit_of_cases) + "</th><th>range</th>";
        const std::vector<std::string> names = fault_names(result, family);
        for (std::size_t i = 0; i < columns; ++i) {
            const std::string name = i < names.size() ? names[i] : "";
            html +=
                "<th>" + escaped(name) + (name.empty() ? "" : ", per million") + "</th><th></th>";
        }
        if (!result.unit_of_error.empty()) {
            html += "<th>error, median</th><th>99 %</th><th>largest</th>";
        }
        html += "<th></th></tr>\n";
        for (const Measurement& one : result.measurements) {
            if (one.family == family) {
                html += measurement_row(result, one, columns);
            }
        }
    }
    return html + "</table>\n";
}

std::string picture_row(const std::string& knob, const std::vector<PagePicture>& pictures) {
    std::string html;
    for (const PagePicture& picture : pictures) {
        if (picture.knob == knob) {
            html += "<figure><img alt='" + escaped(picture.caption) +
                    "' src='data:image/png;base64," + to_base64(picture.png) + "'><figcaption>" +
                    escaped(picture.caption) + "</figcaption></figure>\n";
        }
    }
    return html.empty() ? "" : "<div class='pictures'>\n" + html + "</div>\n";
}

std::string section(const KnobResult& result, const std::vector<PagePicture>& pictures) {
    std::string html = "<h2>" + escaped(result.name) + "</h2>\n<p>" + escaped(result.question);
    if (!result.unit_of_error.empty()) {
        html += " Error: " + escaped(result.unit_of_error) + ".";
    }
    html += "</p>\n";
    if (!result.source.empty()) {
        html += "<p class='note'>" + escaped(result.source) + "</p>\n";
    }
    html += plots_of(result) + picture_row(result.name, pictures);
    return html + "<details><summary>All figures</summary>\n" + measurement_table(result) +
           "</details>\n";
}

} // namespace

std::string to_html(const AccuracyReport& report, const std::vector<PagePicture>& pictures) {
    std::string html = "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'>\n"
                       "<meta name='viewport' content='width=device-width'>\n"
                       "<title>What accuracy costs in time</title>\n" +
                       std::string(style) + "</head><body>\n<h1>What accuracy costs in time</h1>\n";
    html += "<table>\n";
    for (const auto& [name, value] : report.circumstances) {
        html +=
            "<tr><td>" + escaped(name) + "</td><td class='left'>" + escaped(value) + "</td></tr>\n";
    }
    html += "</table>\n<h2>What to take</h2>\n" + advice_table(report.advice);
    html += "<h2>What " + escaped(report.scene) + " needs</h2>\n<ul>\n";
    for (const std::string& sentence : report.scene_needs) {
        html += "<li>" + escaped(sentence) + "</li>\n";
    }
    html += "</ul>\n<p class='note'>In the plots, left is cheaper and low is more accurate; lines "
            "are ranges of rounds, and bounds of 95 %. A triangle that points down is an upper "
            "bound: no fault was seen, in so many cases. Hollow marks are dominated: another is "
            "surely better in one way, and surely worse in none. Rest the pointer on a mark to "
            "read its numbers.</p>\n";
    for (const KnobResult& result : report.results) {
        if (result.kind != KnobKind::speed_only) {
            html += section(result, pictures);
        }
    }
    for (const KnobResult& result : report.results) {
        if (result.kind == KnobKind::speed_only) {
            html += section(result, pictures);
        }
    }
    return html + "</body></html>\n";
}

} // namespace raysteps
