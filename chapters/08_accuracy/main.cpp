// Chapter 08: what accuracy costs in time, choice by choice, in one report.
#include "make_report.h"
#include "program/command.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 08: what accuracy costs in time. Methods side by side, judged exactly.");
    Command command{.chapter = "08_accuracy", .scene = "bunny", .size = "96x96"};
    ReportRequest request;
    bool full = false;
    bool quick = false;
    add_common_options(app, command);
    app.add_flag("--quick", quick, "under a minute, as it is usual");
    app.add_flag("--full", full, "more rays, larger pictures and more rounds: some minutes")
        ->excludes("--quick");
    app.add_option("--trade-offs,--knobs", request.trade_offs,
                   "only these, between commas: " + trade_off_names())
        ->delimiter(',');
    app.add_option("--seed", request.seed, "of all random rays")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    auto* rounds = app.add_option("--rounds", request.rounds,
                                  "how often each method is measured, after one that is dropped");
    rounds->check(CLI::Range(1, 1000))->capture_default_str();
    return run_command(app, command, argc, argv, [&] {
        refuse_window(command);
        request.effort = full ? full_effort() : Effort{};
        if (app.count("--size") > 0) {
            request.effort.picture_size = side_of_pictures(command);
        }
        if (rounds->count() == 0) {
            request.rounds = request.effort.rounds;
        }
        request.own_scene = app.count("--scene") > 0;
        make_report(command, request);
    });
}
