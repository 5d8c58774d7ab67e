// The hard cases by every method: who passes, who fails.
#include "basics/error.h"
#include "basics/file.h"
#include "fuzz.h"
#include "program/command.h"
#include "program/deliver.h"
#include "program/progress.h"
#include "trials.h"

#include <unistd.h>

#include <iostream>

using namespace raysteps;

namespace {

// What the program is to do.
struct TrialRequest {
    std::string name; // of one case; empty for all
    bool list = false;
    int rays = 0; // 0: the usual number
    bool is_long = false;
    double fuzz_seconds = 0.0;
    int seed = 1;
    std::string by = "both";
    std::filesystem::path csv;
};

constexpr int rays_of_the_long_form = 10000000;

void list_trials() {
    for (const Trial& trial : all_trials()) {
        std::cout << trial.name << std::string(6 - trial.name.size(), ' ') << trial.title << "\n";
    }
}

std::vector<Trial> chosen_trials(const TrialRequest& request) {
    if (!request.name.empty()) {
        return {find_trial(request.name)};
    }
    return request.is_long ? leak_trials() : all_trials();
}

void check(const TrialRequest& request) {
    if (request.by != "cpp" && request.by != "gpu" && request.by != "both") {
        throw InputError("--by " + request.by + ": take cpp, gpu or both.");
    }
}

std::vector<TrialResult> try_all(const std::vector<Trial>& trials, TrialTools tools) {
    const Colors colors = isatty(STDOUT_FILENO) != 0 ? Colors::terminal : Colors::none;
    std::vector<TrialResult> results;
    for (const Trial& trial : trials) {
        tools.progress = show_progress(trial.name);
        results.push_back({trial, trial.run(tools)});
        std::cout << to_table(results.back(), colors) << std::flush;
    }
    return results;
}

// Only the numbers that an OBJ file can hold come back from it; the seed makes the scene again.
void run_fuzz(const Command& command, const TrialRequest& request, GpuMethods* gpu) {
    const FuzzResult result = fuzz({.first_seed = request.seed,
                                    .seconds = request.fuzz_seconds,
                                    .gpu = gpu,
                                    .progress = show_progress("fuzzing")});
    std::cout << result.scenes << " seeds, " << result.walks << " walks\n";
    if (!result.fault) {
        return;
    }
    const std::vector<std::filesystem::path> paths = write_fault(*result.fault, command.out);
    std::cout << "wrote     " << paths[0].string() << "\nwrote     " << paths[1].string() << "\n";
    throw Error(ExitCode::check_failed,
                "seed " + std::to_string(result.fault->seed) + ": " + result.fault->method + " " +
                    result.fault->what + ". Run it again with --seed " +
                    std::to_string(result.fault->seed) + " --fuzz 1, or trace its files with " +
                    "./run.sh 06 --scene " + paths[0].string() + " --rays " + paths[1].string() +
                    " --hits hits.csv --structure NAME.");
}

nlohmann::ordered_json to_json(std::span<const TrialResult> results) {
    nlohmann::ordered_json cases = nlohmann::ordered_json::array();
    for (const TrialResult& result : results) {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const TrialRow& row : result.rows) {
            rows.push_back({{"method", row.method},
                            {"where", row.where},
                            {"expected", row.expected},
                            {"got", row.got},
                            {"verdict", to_words(row.verdict)},
                            {"tried", row.tried},
                            {"wrong", row.wrong}});
        }
        cases.push_back({{"case", result.trial.name},
                         {"title", result.trial.title},
                         {"source", result.trial.source},
                         {"remedy", result.trial.remedy},
                         {"rows", rows}});
    }
    return cases;
}

// Throws Error with exit code 1 where a promise is broken.
void run_trials(const Command& command, const TrialRequest& request) {
    check(request);
    if (request.list) {
        list_trials();
        return;
    }
    const std::vector<Trial> trials = chosen_trials(request);
    std::unique_ptr<Context> context;
    std::unique_ptr<GpuMethods> gpu;
    if (request.by != "cpp") {
        context = open_context(command);
        gpu = std::make_unique<GpuMethods>(measure_limits());
    }
    std::cout << "seed      " << request.seed << "\n";
    if (request.fuzz_seconds > 0.0) {
        run_fuzz(command, request, gpu.get());
        return;
    }
    const int rays = request.is_long && request.rays == 0 ? rays_of_the_long_form : request.rays;
    const std::vector<TrialResult> results = try_all(
        trials,
        {.rays = rays, .seed = request.seed, .gpu = gpu.get(), .by_mirror = request.by != "gpu"});
    if (!request.csv.empty()) {
        write_file(request.csv, to_csv(results));
    }
    deliver_numbers(command, to_json(results));
    const std::size_t broken = count_rows(results, Verdict::fail);
    std::cout << "\n"
              << count_rows(results, Verdict::pass) << " promises kept, " << broken << " broken, "
              << count_rows(results, Verdict::reported)
              << " figures that nothing was promised for\n";
    if (broken > 0) {
        throw Error(ExitCode::check_failed,
                    "promises broken: " + std::to_string(broken) +
                        ". See the lines that say FAIL, and run one case again with --case.");
    }
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Hard cases: where usual methods go wrong, and what this project promises.");
    Command command{.chapter = "hard_cases"};
    command.out = std::filesystem::path("out") / command.chapter;
    TrialRequest request;
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.add_option("--case", request.name, "only this case, for example T1; see --list");
    app.add_flag("--list", request.list, "print the names and titles of all cases");
    app.add_option("--rays", request.rays, "rays per case, up to what makes sense for it")
        ->check(CLI::Range(1, 1 << 30));
    app.add_flag("--long", request.is_long,
                 "ten million rays (or --rays) at shared edges and as many at shared corners of "
                 "a closed mesh, through every structure");
    app.add_option("--fuzz", request.fuzz_seconds,
                   "seconds of fuzzing: random meshes and rays with garbage bits, every structure "
                   "against the loop");
    app.add_option("--seed", request.seed, "seed of all random numbers")->capture_default_str();
    app.add_option("--by", request.by, "which implementations to try: cpp, gpu or both")
        ->capture_default_str();
    app.add_option("--context", command.context, "where OpenGL runs: auto, osmesa, egl or window")
        ->capture_default_str();
    app.add_option("--out", command.out, "the folder for what the fuzzer finds")
        ->capture_default_str();
    app.add_option("--json", command.json, "a file for the rows of the table");
    app.add_option("--csv", request.csv, "a file for the rows of the table");
    return run_command(app, command, argc, argv, [&] { run_trials(command, request); });
}
