// The hard cases by every method: who passes, who fails.
#include "basics/error.h"
#include "basics/file.h"
#include "conformance.h"
#include "fuzz.h"
#include "hard_cases/hard_cases.h"
#include "program/figures.h"
#include "program/options.h"
#include "trials.h"

#include <unistd.h>

#include <iostream>

using namespace raysteps;

namespace {

// What the program is to do.
struct TrialRequest {
    std::string name; // of one case; empty for all
    int rays = 0;     // 0: the usual number
    bool is_long = false;
    double fuzz_seconds = 0.0;
    int seed = 1;
    std::string by = "both";
    ContextKind context = ContextKind::automatic;
    std::filesystem::path out = "out/hard_cases"; // for what the fuzzer finds
    std::filesystem::path json;
    std::filesystem::path csv;
    std::string tree;            // of the case's mesh
    std::filesystem::path mesh;  // for that of the case
    std::filesystem::path suite; // the folder of the conformance suite
};

constexpr int rays_of_the_long_form = 10000000;
constexpr int rays_of_the_small_suite = 500;

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
void run_fuzz(const TrialRequest& request, GpuMethods* gpu) {
    const FuzzResult result = fuzz({.first_seed = request.seed,
                                    .seconds = request.fuzz_seconds,
                                    .gpu = gpu,
                                    .progress = show_progress("fuzzing")});
    std::cout << result.scenes << " seeds, " << result.walks << " walks\n";
    if (!result.fault) {
        return;
    }
    const std::vector<std::filesystem::path> paths = write_fault(*result.fault, request.out);
    print_written(paths[0]);
    print_written(paths[1]);
    throw Error(ExitCode::check_failed,
                "seed " + std::to_string(result.fault->seed) + ": " + result.fault->method + " " +
                    result.fault->what + ". Run it again with --seed " +
                    std::to_string(result.fault->seed) + " --fuzz 1, or trace its files with " +
                    "./run.sh 06 --scene " + paths[0].string() + " --rays " + paths[1].string() +
                    " --hits hits.csv --structure NAME.");
}

Numbers numbers_of(std::span<const TrialResult> results) {
    Numbers cases = empty_list();
    for (const TrialResult& result : results) {
        Numbers rows = empty_list();
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
void run_trials(const TrialRequest& request) {
    if (!request.suite.empty()) {
        write_conformance_suite(
            request.suite,
            {request.rays == 0 ? rays_of_the_small_suite : request.rays, request.seed});
        return;
    }
    const std::vector<Trial> trials = chosen_trials(request);
    std::unique_ptr<Context> context;
    std::unique_ptr<GpuMethods> gpu;
    if (request.by != "cpp") {
        context = open_context(request.context);
        gpu = std::make_unique<GpuMethods>(measure_limits());
    }
    std::cout << "seed      " << request.seed << "\n";
    if (request.fuzz_seconds > 0.0) {
        run_fuzz(request, gpu.get());
        return;
    }
    if (!request.mesh.empty()) {
        const HardScene made = find_hard_case(request.name).make({.seed = request.seed});
        write_text(request.mesh, to_obj(made.mesh));
        return;
    }
    const int rays = request.is_long && request.rays == 0 ? rays_of_the_long_form : request.rays;
    const std::vector<TrialResult> results = try_all(trials, {.rays = rays,
                                                              .seed = request.seed,
                                                              .gpu = gpu.get(),
                                                              .by_mirror = request.by != "gpu",
                                                              .tree = request.tree});
    if (!request.csv.empty()) {
        write_file(request.csv, to_csv(results));
    }
    write_figures(request.json, {.schema = "hard_cases.schema.json"},
                  {{"seed", request.seed}, {"cases", numbers_of(results)}});
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
    Options options("hard_cases",
                    "Hard cases: where usual methods go wrong, and what this project promises.");
    TrialRequest request;
    options.text("--case", request.name, "only this case, for example T1; see --list");
    options.question("--list", "print the names and titles of all cases", list_trials);
    options.number("--rays", request.rays,
                   "rays per case, up to what makes sense for it; the usual number without it", 1,
                   1 << 30);
    options.flag("--long", request.is_long,
                 "ten million rays (or --rays) at shared edges and as many at shared corners of a "
                 "closed mesh, through every structure");
    options.number("--fuzz", request.fuzz_seconds,
                   "seconds of fuzzing: random meshes and rays with garbage bits, every structure "
                   "against the loop",
                   0.0, 1e9);
    options.number("--seed", request.seed, "seed of all random numbers");
    options.choice("--by", request.by, "which implementations to try", {"cpp", "gpu", "both"});
    add_context_option(options, request.context);
    options.output_folder("--out", request.out, "the folder for what the fuzzer finds");
    options.output_file("--json", request.json, "a file for the rows of the table");
    options.output_file("--csv", request.csv, "a file for the rows of the table");
    options.output_file("--mesh", request.mesh,
                        "write the mesh of --case to this OBJ file, and try nothing");
    options.output_folder("--suite", request.suite,
                          "write the conformance suite into this folder, and try nothing "
                          "(docs/conformance)");
    options.text("--tree", request.tree,
                 "try the walks through the tree of this file, which another program built over "
                 "the mesh of --case (docs/tree_files.md)");
    options.check([&] {
        if ((!request.tree.empty() || !request.mesh.empty()) && request.name.empty()) {
            throw InputError("--tree and --mesh are about the mesh of one case. Name it with "
                             "--case.");
        }
    });
    options.excludes("--fuzz", {"--json", "--csv", "--mesh", "--tree"});
    options.excludes("--suite",
                     {"--case", "--long", "--fuzz", "--json", "--csv", "--mesh", "--tree"});
    return options.run(argc, argv, [&] { run_trials(request); });
}
