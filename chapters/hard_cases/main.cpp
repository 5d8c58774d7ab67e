// The hard cases by every method: who passes, who fails.
#include "basics/error.h"
#include "basics/file.h"
#include "conformance.h"
#include "fuzz.h"
#include "hard_cases/hard_cases.h"
#include "program/figures.h"
#include "program/jobs.h"
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
    JobOptions jobs;
};

constexpr int rays_of_the_long_form = 10000000;
constexpr int rays_of_the_small_suite = 500;

void list_trials() {
    for (const Trial& trial : all_trials()) {
        std::cout << trial.name << std::string(6 - trial.name.size(), ' ') << trial.title << "\n";
    }
}

std::vector<Trial> chosen_trials(const TrialRequest& request) {
    if (request.name.empty()) {
        return request.is_long ? leak_trials() : all_trials();
    }
    const Trial& named = find_trial(request.name);
    if (request.is_long) {
        for (const Trial& trial : leak_trials()) {
            if (trial.name == named.name) {
                return {trial};
            }
        }
    }
    return {named};
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

// The rows of a part's figures.
TrialResult result_of(const Numbers& figures) {
    TrialResult result{find_trial(figures.at("case").text()), {}};
    for (const Numbers& row : figures.at("rows").values()) {
        const std::string& verdict = row.at("verdict").text();
        result.rows.push_back({row.at("method").text(), row.at("where").text(),
                               row.at("expected").text(), row.at("got").text(),
                               verdict == to_words(Verdict::pass)   ? Verdict::pass
                               : verdict == to_words(Verdict::fail) ? Verdict::fail
                                                                    : Verdict::reported,
                               static_cast<std::size_t>(row.at("tried").number()),
                               static_cast<std::size_t>(row.at("wrong").number())});
    }
    return result;
}

// Throws Error with exit code 1 where a promise is broken.
void check_promises(std::span<const TrialResult> results) {
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

void write_trial_jobs(const TrialRequest& request, const std::vector<std::string>& words) {
    std::vector<RunPart> jobs;
    for (const Trial& trial : chosen_trials(request)) {
        jobs.push_back({trial.name, {"--case", trial.name}});
    }
    write_jobs(request.jobs, words, jobs);
}

void merge_trials(const TrialRequest& request) {
    const JobParts parts = read_parts(request.jobs.merge, "hard_cases.schema.json");
    std::vector<TrialResult> results;
    for (const Numbers& figures : parts.figures) {
        for (const Numbers& one : figures.at("cases").values()) {
            results.push_back(result_of(one));
            std::cout << to_table(results.back(), Colors::none);
        }
    }
    if (!request.csv.empty()) {
        write_file(request.csv, to_csv(results));
    }
    if (!request.json.empty()) {
        const Numbers all{{"head", head_of(parts)},
                          {"seed", common_member(parts, "seed")},
                          {"cases", numbers_of(results)}};
        write_text(request.json, all.to_json() + "\n");
    }
    check_complete(parts);
    check_promises(results);
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
    check_promises(results);
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
    add_job_options(options, request.jobs);
    options.excludes("--fuzz", {"--json", "--csv", "--mesh", "--tree", "--jobs-file", "--merge"});
    options.excludes("--suite", {"--case", "--long", "--fuzz", "--json", "--csv", "--mesh",
                                 "--tree", "--jobs-file", "--merge"});
    return options.run(argc, argv, [&] {
        if (!request.jobs.file.empty()) {
            write_trial_jobs(request, words_without(argc, argv,
                                                    {"--jobs-file", "--results", "--case", "--out",
                                                     "--json", "--csv"}));
        } else if (!request.jobs.merge.empty()) {
            merge_trials(request);
        } else {
            run_trials(request);
        }
    });
}
