// Chapter 04: the uniform grid.
#include "program/command.h"
#include "program/measure_command.h"
#include "program/show_trace.h"
#include "program/tracing_options.h"
#include "plot_resolution.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 04: rays through the cells of a uniform grid.");
    Command command{.chapter = "04_grid", .scene = "bunny"};
    command.structure = "grid";
    std::string view = "normals";
    bool measure = false;
    bool plot = false;
    add_common_options(app, command);
    add_tracing_options(app, command);
    add_view_option(app, view);
    app.add_flag("--measure", measure, "measure the grid with and without repeated tests")
        ->excludes("--rays", "--window", "--structure", "--view");
    app.add_flag("--plot", plot, "plot steps, tests and time against the resolution")
        ->excludes("--rays", "--window", "--measure", "--view", "--resolution", "--density");
    return run_command(app, command, argc, argv, [&] {
        if (measure || plot) {
            const Scene scene = open_scene(command);
            const auto context = open_context(command);
            if (plot) {
                plot_resolution(command, scene);
            } else {
                measure_and_report(command, scene, {"grid", "grid_mailbox"});
            }
            return;
        }
        show_trace(command, view);
    });
}
