// The hard cases by every method: who passes, who fails.
#include "program/command.h"
#include "run_trials.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Hard cases: where usual methods go wrong, and what this project promises.");
    Command command{.chapter = "hard_cases"};
    command.out = std::filesystem::path("out") / command.chapter;
    TrialRequest request;
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.add_option("--case", request.name, "only this one, as in T1; --list names them all");
    app.add_flag("--list", request.list, "print the names and titles of all cases");
    app.add_option("--rays", request.rays, "rays of each case, where so many make sense")
        ->check(CLI::Range(1, 1 << 30));
    app.add_flag("--long", request.is_long,
                 "ten million rays at shared edges and ten million at shared corners of a closed "
                 "mesh, or --rays of each, through every structure");
    app.add_option("--fuzz", request.fuzz_seconds,
                   "for so many seconds: random meshes and rays with garbage bits, every "
                   "structure against the loop");
    app.add_option("--seed", request.seed, "of all random numbers")->capture_default_str();
    app.add_option("--by", request.by, "cpp, gpu or both")->capture_default_str();
    app.add_option("--context", command.context, "where OpenGL runs: auto, osmesa, egl or window")
        ->capture_default_str();
    app.add_option("--out", command.out, "the folder for what the fuzzer finds")
        ->capture_default_str();
    app.add_option("--json", command.json, "a file for the rows");
    app.add_option("--csv", request.csv, "a file for the rows");
    return run_command(app, command, argc, argv, [&] { run_trials(command, request); });
}
