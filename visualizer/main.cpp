// The visualizer: what a structure looks like, and how a ray walks through it.
#include "basics/error.h"
#include "finding.h"
#include "framing.h"
#include "json_files.h"
#include "keys.h"
#include "pointing.h"
#include "request.h"

#include <iostream>
#include <new>

#include <unistd.h>

using namespace raysteps;

namespace {

int fail(ExitCode code, const std::string& sentence) {
    std::cerr << "visualizer: " << sentence << "\n";
    return static_cast<int>(code);
}

void say_on_terminal(const std::string& what) {
    if (isatty(STDERR_FILENO) != 0) {
        std::cerr << what << " ...\n";
    }
}

void run(int argc, char** argv) {
    view::Request request = view::read_request(argc, argv);
    if (!request.help.empty()) {
        std::cout << request.help;
        return;
    }
    view::Stage stage(say_on_terminal);
    stage.show(request.state);
    for (const std::string& message : stage.scene().messages) {
        std::cerr << message << "\n";
    }
    if (request.to_parting) {
        request.state = view::after_key(request.state, stage, "d");
    }
    request.state = view::with_selected(request.state, stage, request.state.selected);
    if (!request.sought.empty()) {
        request.state = view::with_found(request.state, stage, request.sought);
    }
    if (request.fly) {
        request.state.viewpoint = view::fly_to_step(stage, request.state);
    }
    if (!request.save_to.empty()) {
        view::save_state(request.save_to, request.state);
        std::cout << "wrote     " << request.save_to.string() << "\n";
    }
    view::show_view(request, stage);
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
        return static_cast<int>(ExitCode::done);
    } catch (const Error& error) {
        return fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::machine_lacks, "out of memory. Use a smaller scene.");
    } catch (const std::exception& error) {
        return fail(ExitCode::machine_lacks, std::string("Internal error: ") + error.what() +
                                                 ". This is a bug in Raysteps; please report it.");
    }
}
