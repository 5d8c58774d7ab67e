// Chapter 05: the kd-tree, walked without a stack.
#include "program/command.h"
#include "program/measure_command.h"
#include "program/show_trace.h"
#include "program/tracing_options.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 05: rays through a kd-tree, in four ways without a full stack.");
    Command command{.chapter = "05_kd_tree", .scene = "bunny"};
    command.structure = "kd_restart";
    std::string view = "normals";
    bool measure = false;
    add_common_options(app, command);
    add_tracing_options(app, command);
    add_view_option(app, view);
    app.add_flag("--measure", measure, "measure all four walks, and the grid beside them")
        ->excludes("--rays", "--window", "--structure", "--view");
    return run_command(app, command, argc, argv, [&] {
        if (measure) {
            const Scene scene = open_scene(command);
            const auto context = open_context(command);
            measure_and_report(
                command, scene,
                {"grid", "kd_restart", "kd_backtrack", "kd_short_stack", "kd_ropes"});
            return;
        }
        show_trace(command, view);
    });
}
