// Chapter 06: the bounding volume hierarchy.
#include "program/command.h"
#include "program/measure_command.h"
#include "program/show_trace.h"
#include "program/tracing_options.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 06: rays through a hierarchy of boxes.");
    Command command{.chapter = "06_bvh", .scene = "bunny"};
    command.structure = "bvh_ordered";
    std::string view = "normals";
    bool measure = false;
    add_common_options(app, command);
    add_tracing_options(app, command);
    add_view_option(app, view);
    app.add_flag("--measure", measure, "measure all walks of the hierarchy, side by side")
        ->excludes("--rays", "--window", "--structure", "--view");
    return run_command(app, command, argc, argv, [&] {
        if (measure) {
            const Scene scene = open_scene(command);
            const auto context = open_context(command);
            measure_and_report(command, scene,
                               {"bvh_skip", "bvh_ordered", "bvh_parent", "bvh_stack"});
            return;
        }
        show_trace(command, view);
    });
}
