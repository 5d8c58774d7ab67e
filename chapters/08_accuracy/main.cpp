// Chapter 08: what accuracy costs in time, choice by choice, in one report.
#include "make_report.h"

using namespace raysteps;

int main(int argc, char** argv) {
    Options options("08_accuracy",
                    "Chapter 08: what accuracy costs in time. Methods side by side, judged "
                    "exactly.");
    PictureOptions picture{.scene = "bunny", .size = {96, 96}};
    ReportRequest request;
    bool full = false;
    bool quick = false;
    add_picture_options(options, picture);
    options.flag("--quick", quick, "the default: takes under a minute");
    options.flag("--full", full, "more rays, larger pictures and more rounds: takes some minutes");
    options.excludes("--full", {"--quick"});
    options.list("--trade-offs,--knobs", request.trade_offs,
                 "only these, between commas: " + trade_off_names());
    options.number("--seed", request.seed, "seed of all random rays", 0);
    options.number("--rounds", request.rounds,
                   "how often each method is measured, after one round that is dropped", 1, 1000);
    add_job_options(options, request.jobs);
    return options.run(argc, argv, [&] {
        refuse_window(picture);
        if (!request.jobs.file.empty()) {
            write_report_jobs(request, words_without(argc, argv,
                                                     {"--jobs-file", "--results", "--trade-offs",
                                                      "--knobs", "--out", "--json"}));
            return;
        }
        if (!request.jobs.merge.empty()) {
            merge_report(picture, request);
            return;
        }
        request.effort = full ? full_effort() : Effort{};
        if (options.given("--size")) {
            request.effort.picture_size = side_of_pictures(picture.size);
        }
        if (!options.given("--rounds")) {
            request.rounds = request.effort.rounds;
        }
        request.own_scene = options.given("--scene");
        make_report(picture, request);
    });
}
