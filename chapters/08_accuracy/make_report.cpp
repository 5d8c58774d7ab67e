#include "make_report.h"

#include "basics/data_folder.h"
#include "basics/error.h"
#include "basics/file.h"
#include "basics/text.h"
#include "gpu/context.h"
#include "image/image_file.h"
#include "program/figures.h"
#include "scene/view.h"
#include "scene_needs.h"
#include "structure/padding.h"
#include "subject.h"
#include "trade_offs.h"
#include "verdict.h"

#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace raysteps {

namespace {

// All that a report says.
struct AccuracyReport {
    SceneRecord scene;
    std::vector<std::pair<std::string, std::string>> circumstances{};
    std::vector<std::string> scene_needs{}; // sentences
    std::vector<TradeOffResult> results{};
    std::vector<Advice> advice{};
};

// The processor time of the process where OpenGL runs on the processor, else the clock on the wall.
Clock clock_of_renderer() {
    return runs_on_processor(renderer_name()) ? Clock::processor : Clock::wall;
}

// What somebody needs to measure again beside what the head has: clock, compiler and its flags,
// seed, rounds and rays.
std::vector<std::pair<std::string, std::string>> circumstances_of(const Effort& effort) {
    return {
        {"time", clock_of_renderer() == Clock::processor
                     ? "processor time of the process, all threads together"
                     : "time on the wall"},
        {"compiler", RAYSTEPS_COMPILER},
        {"flags", RAYSTEPS_FLAGS},
        {"seed", std::to_string(effort.seed)},
        {"rounds", fmt::format("{}, after one that is dropped; methods take turns", effort.rounds)},
        {"rays per family",
         fmt::format("{}, of which {} are timed", effort.judged_rays, effort.timed_rays)}};
}

std::string measures_of(const Findings& findings, const std::string& between) {
    std::string text;
    for (const Measure& measure : findings.measures) {
        text += fmt::format("{}{} {:.6g}", between, measure.name, measure.value);
    }
    return text;
}

// For people: one line per family and method.
std::string table_of(const TradeOffResult& result) {
    std::string table = fmt::format(
        "\n{}: {}\nfaults are per million cases, in brackets with 95 % confidence: of some, both "
        "bounds (two-sided), of none, < the upper one (one-sided){}\n",
        result.name, result.question,
        result.unit_of_error.empty() ? "" : "; error: " + result.unit_of_error);
    for (const std::string& family : families_of(result)) {
        table += "  " + family + "\n";
        for (const Measurement& one : result.measurements) {
            if (one.family != family) {
                continue;
            }
            table += fmt::format("    {:26} {:8.4g} ns per {} ({:.4g} to {:.4g})", one.method,
                                 one.cost.median, result.unit_of_cases, one.cost.lowest,
                                 one.cost.highest);
            for (const Fault& fault : one.findings.faults) {
                table += fmt::format("  {} {}", fault.name,
                                     to_string(fault_rate(fault.count, fault.of)));
            }
            if (one.findings.error) {
                table += "  error " + to_string(*one.findings.error);
            }
            table += measures_of(one.findings, "  ") + "\n";
        }
    }
    return table;
}

// For programs: a line of names, then one line per trade-off, family and method.
std::string to_csv(std::span<const TradeOffResult> results) {
    std::string csv = "trade_off,family,method,timed_cases,nanoseconds,lowest,highest,faults,of,"
                      "per_million,two_sided_lower_bound,two_sided_upper_bound,"
                      "one_sided_upper_bound,error_median,error_99,error_largest,unit_of_error,"
                      "measures\n";
    for (const TradeOffResult& result : results) {
        for (const Measurement& one : result.measurements) {
            const Fault total = total_fault(one.findings);
            const FaultRate rate = fault_rate(total.count, total.of);
            csv += csv_field(result.name) + "," + csv_field(one.family) + "," +
                   csv_field(one.method) +
                   fmt::format(",{},{:.9g},{:.9g},{:.9g},", one.timed_cases, one.cost.median,
                               one.cost.lowest, one.cost.highest);
            csv += total.of == 0
                       ? ",,,"
                       : fmt::format("{},{},{:.9g},", total.count, total.of, rate.counted);
            csv += total.of == 0        ? ",,,"
                   : is_one_sided(rate) ? fmt::format(",,{:.9g},", rate.highest)
                                        : fmt::format("{:.9g},{:.9g},,", rate.lowest, rate.highest);
            const auto& error = one.findings.error;
            csv += error ? fmt::format("{:.9g},{:.9g},{:.9g},", error->median, error->percentile_99,
                                       error->largest)
                         : ",,,";
            csv += csv_field(result.unit_of_error) + "," +
                   csv_field(measures_of(one.findings, "; ")) + "\n";
        }
    }
    return csv;
}

std::string file_name_of(std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) == 0; }, '_');
    return text;
}

// Within the folder of the report.
std::string file_of(const TradeOffResult& result, const TradeOffPicture& picture) {
    return "pictures/" + file_name_of(result.name + " " + picture.caption) + ".png";
}

std::string to_word(TradeOffKind kind) {
    switch (kind) {
    case TradeOffKind::methods:
        return "methods";
    case TradeOffKind::pictures:
        return "pictures";
    case TradeOffKind::illustration:
        return "illustration";
    case TradeOffKind::speed_only:
        break;
    }
    return "speed_only";
}

// The numbers with the rate's: an upper bound that stands alone has another name than one of two.
Numbers with_rate(Numbers numbers, const FaultRate& rate) {
    numbers["per_million"] = rate.counted;
    if (is_one_sided(rate)) {
        numbers["one_sided_upper_bound"] = rate.highest;
        return numbers;
    }
    numbers["two_sided_lower_bound"] = rate.lowest;
    numbers["two_sided_upper_bound"] = rate.highest;
    return numbers;
}

// A method over all families.
Numbers method_numbers(const MethodSummary& method, bool dominated) {
    Numbers numbers{{"method", method.method},
                    {"nanoseconds", method.cost.median},
                    {"lowest", method.cost.lowest},
                    {"highest", method.cost.highest},
                    {"dominated", dominated}};
    if (method.faults) {
        numbers["faults"] = with_rate(empty_object(), *method.faults);
    }
    if (method.error) {
        numbers["error"] = *method.error;
    }
    return numbers;
}

Numbers measurement_numbers(const Measurement& one) {
    Numbers numbers{{"method", one.method},           {"family", one.family},
                    {"timed_cases", one.timed_cases}, {"nanoseconds", one.cost.median},
                    {"lowest", one.cost.lowest},      {"highest", one.cost.highest},
                    {"faults", empty_list()},         {"measures", empty_object()}};
    for (const Fault& fault : one.findings.faults) {
        numbers["faults"].push_back(
            with_rate({{"name", fault.name}, {"count", fault.count}, {"of", fault.of}},
                      fault_rate(fault.count, fault.of)));
    }
    if (one.findings.error) {
        numbers["error"] = Numbers{{"median", one.findings.error->median},
                                   {"percentile_99", one.findings.error->percentile_99},
                                   {"largest", one.findings.error->largest}};
    }
    for (const Measure& measure : one.findings.measures) {
        numbers["measures"][measure.name] = measure.value;
    }
    return numbers;
}

Numbers result_numbers(const TradeOffResult& result) {
    Numbers numbers{{"trade_off", result.name},
                    {"question", result.question},
                    {"source", result.source},
                    {"kind", to_word(result.kind)},
                    {"unit_of_cases", result.unit_of_cases},
                    {"unit_of_error", result.unit_of_error},
                    {"methods", empty_list()},
                    {"measurements", empty_list()},
                    {"pictures", empty_list()}};
    const std::vector<MethodSummary> summaries = summarize_methods(result);
    for (const MethodSummary& method : summaries) {
        numbers["methods"].push_back(method_numbers(method, is_dominated(method, summaries)));
    }
    for (const Measurement& one : result.measurements) {
        numbers["measurements"].push_back(measurement_numbers(one));
    }
    for (const TradeOffPicture& picture : result.pictures) {
        numbers["pictures"].push_back(
            {{"caption", picture.caption}, {"file", file_of(result, picture)}});
    }
    return numbers;
}

// For programs, and for scripts/accuracy_page.
Numbers to_numbers(const AccuracyReport& report) {
    Numbers numbers{{"circumstances", empty_object()},
                    {"scene_needs", report.scene_needs},
                    {"advice", empty_list()},
                    {"trade_offs", empty_list()}};
    for (const auto& [name, value] : report.circumstances) {
        numbers["circumstances"][name] = value;
    }
    for (const Advice& one : report.advice) {
        numbers["advice"].push_back({{"trade_off", one.trade_off},
                                     {"need", one.need},
                                     {"condition", one.condition},
                                     {"methods", one.methods}});
    }
    for (const TradeOffResult& result : report.results) {
        numbers["trade_offs"].push_back(result_numbers(result));
    }
    return numbers;
}

// accuracy.html beside the JSON file, by the script of the project.
void make_page(const std::filesystem::path& json) {
    std::filesystem::path page = json;
    page.replace_extension(".html");
    const auto scripts = data_folder(RAYSTEPS_SOURCE_DIR "/scripts", "scripts");
    std::string words[] = {"python3", "-B", (scripts / "accuracy_page").string(), json.string()};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                         nullptr};
    pid_t child = 0;
    int status = 0;
    if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments, environ) != 0 ||
        (waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 127)) {
        throw MachineError(page.string() +
                           ": python3 is missing, so there is no page. Install the "
                           "package python3, and run python3 "
                           "scripts/accuracy_page " +
                           json.string() + ".");
    }
    if (status != 0) {
        throw MachineError(page.string() + ": scripts/accuracy_page does not make it, for the "
                                           "reason above.");
    }
    print_written(page);
}

constexpr std::uintmax_t most_bytes_of_report = 256U << 20U;

// Exact truth takes a time for each ray and triangle; a family keeps so many rays at least.
constexpr std::size_t most_decisions = 100'000'000;
constexpr std::size_t fewest_rays = 1024;

std::vector<TradeOffMaker> chosen_makers(const std::vector<std::string>& names) {
    std::vector<TradeOffMaker> chosen;
    for (const TradeOffMaker& maker : trade_off_makers()) {
        if (names.empty() || std::find(names.begin(), names.end(), maker.name) != names.end()) {
            chosen.push_back(maker);
        }
    }
    for (const std::string& name : names) {
        if (std::none_of(chosen.begin(), chosen.end(),
                         [&](const TradeOffMaker& maker) { return maker.name == name; })) {
            throw InputError("--trade-offs " + name + ": there is no such choice. Take some of " +
                             trade_off_names() + ".");
        }
    }
    return chosen;
}

// As many rays as a large scene leaves time for.
Effort affordable(Effort effort, const Subject& mesh) {
    const auto triangles = static_cast<std::size_t>(std::max(1, triangle_count(mesh.scene)));
    const std::size_t rays = std::max(fewest_rays, most_decisions / triangles);
    effort.judged_rays = std::min(effort.judged_rays, rays);
    effort.timed_rays = std::min(effort.timed_rays, effort.judged_rays);
    return effort;
}

// Nobody should wait for minutes to learn that a file cannot be written. What is there stays.
void check_writable(const std::filesystem::path& path) {
    if (std::filesystem::is_regular_file(path)) {
        write_file(path, read_file(path, most_bytes_of_report));
        return;
    }
    write_file(path, "");
    std::filesystem::remove(path);
}

void print_advice(const std::vector<Advice>& advice) {
    std::cout << "\nWhat to take (no rank among those named together)\n";
    for (const Advice& one : advice) {
        std::cout << "  " << one.trade_off << ", " << one.need << " (" << one.condition << "):";
        for (std::size_t i = 0; i < one.methods.size(); ++i) {
            std::cout << (i == 0 ? " " : "; ") << one.methods[i];
        }
        std::cout << (one.methods.empty() ? " none of these\n" : "\n");
    }
}

} // namespace

Effort full_effort() {
    Effort effort;
    effort.judged_rays = 131072;
    effort.timed_rays = 16384;
    effort.rounds = 15;
    effort.picture_size = 192;
    effort.finest_grid = 1024;
    effort.most_samples = 4;
    return effort;
}

std::string trade_off_names() {
    std::string names;
    for (const TradeOffMaker& maker : trade_off_makers()) {
        names += (names.empty() ? "" : ", ") + maker.name;
    }
    return names;
}

void refuse_window(const PictureOptions& picture) {
    if (picture.window) {
        throw InputError("--window: the report of chapter 08 is a page. Leave the option out, and "
                         "open accuracy.html in a browser.");
    }
}

int side_of_pictures(const PictureSize& size) {
    return std::max(8, std::min(size.width, size.height));
}

void make_report(const PictureOptions& options, const ReportRequest& request) {
    const std::vector<TradeOffMaker> makers = chosen_makers(request.trade_offs);
    Scene scene = load_scene(options);
    const auto context = open_context(options);
    if (!options.json.empty()) {
        check_writable(options.json);
    }
    check_writable(options.out / "accuracy.html");
    TradeOffRequest trade_offs{nullptr, nullptr, request.effort};
    trade_offs.effort.limits = measure_limits();
    trade_offs.effort.seed = request.seed;
    trade_offs.effort.rounds = request.rounds;
    const SceneNeeds needs = find_needs(scene);
    const SceneRecord scene_record = record_of(scene);
    const float reach = reach_of(origins_of(scene.camera), scene.corners);
    trade_offs.scene = make_subject(std::move(scene), reach);
    const bool aim_at_scene = request.own_scene && needs.triangles > needs.without_area;
    trade_offs.mesh = aim_at_scene ? trade_offs.scene : usual_subject();
    trade_offs.effort = affordable(trade_offs.effort, *trade_offs.mesh);

    AccuracyReport report{.scene = scene_record,
                          .circumstances = circumstances_of(trade_offs.effort),
                          .scene_needs = to_sentences(needs)};
    for (const TradeOffMaker& maker : makers) {
        report.results.push_back(measure_trade_off(maker.make(trade_offs), request.rounds,
                                                   clock_of_renderer(),
                                                   show_progress("comparing " + maker.name)));
        const TradeOffResult& result = report.results.back();
        std::cout << table_of(result) << std::flush;
        for (Advice& advice : advise(result)) {
            report.advice.push_back(std::move(advice));
        }
        for (const TradeOffPicture& picture : result.pictures) {
            write_png(options.out / file_of(result, picture), picture.image);
        }
    }
    print_advice(report.advice);
    std::cout << "\nWhat " << options.scene << " needs\n";
    for (const std::string& sentence : report.scene_needs) {
        std::cout << "  " << sentence << "\n";
    }
    write_text(options.out / "accuracy.csv", to_csv(report.results));
    const FiguresHead head{.schema = "accuracy.schema.json", .scenes = {report.scene}};
    const Numbers figures = to_numbers(report);
    write_figures(options.out / "accuracy.json", head, figures);
    write_figures(options.json, head, figures);
    std::cout << std::flush;
    make_page(options.out / "accuracy.json");
}

void write_report_jobs(const ReportRequest& request, const std::vector<std::string>& words) {
    std::vector<RunPart> jobs;
    for (const TradeOffMaker& maker : chosen_makers(request.trade_offs)) {
        jobs.push_back({maker.name, {"--trade-offs", maker.name}});
    }
    write_jobs(request.jobs, words, jobs);
}

void merge_report(const PictureOptions& picture, const ReportRequest& request) {
    const JobParts parts = read_parts(request.jobs.merge, "accuracy.schema.json");
    Numbers all{{"head", head_of(parts)},
                {"circumstances", common_member(parts, "circumstances")},
                {"scene_needs", common_member(parts, "scene_needs")},
                {"advice", empty_list()},
                {"trade_offs", empty_list()}};
    std::string csv;
    for (std::size_t i = 0; i < parts.figures.size(); ++i) {
        for (const std::string name : {"advice", "trade_offs"}) {
            for (const Numbers& one : parts.figures[i].at(name).values()) {
                all[name].push_back(one);
            }
        }
        const std::filesystem::path folder = request.jobs.merge / parts.names[i];
        const std::string own = read_file(folder / "accuracy.csv", most_bytes_of_report);
        csv += csv.empty() ? own : own.substr(own.find('\n') + 1);
        if (std::filesystem::exists(folder / "pictures")) {
            std::filesystem::create_directories(picture.out);
            std::filesystem::copy(folder / "pictures", picture.out / "pictures",
                                  std::filesystem::copy_options::recursive |
                                      std::filesystem::copy_options::overwrite_existing);
        }
    }
    write_text(picture.out / "accuracy.csv", csv);
    write_text(picture.out / "accuracy.json", all.to_json() + "\n");
    if (!picture.json.empty()) {
        write_text(picture.json, all.to_json() + "\n");
    }
    std::cout << std::flush;
    make_page(picture.out / "accuracy.json");
    check_complete(parts);
}

} // namespace raysteps
