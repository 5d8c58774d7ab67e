#include "report/gnuplot.h"

#include "error/error.h"
#include "file/write_file.h"

#include <sys/wait.h>

#include <cstdlib>

namespace raysteps {

std::string gnuplot_text(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        safe += letter == '\'' || letter == '\n' ? ' ' : letter;
    }
    return "'" + safe + "'";
}

void run_gnuplot(const std::filesystem::path& png, const std::string& script_text) {
    if (png.string().find_first_of("'\n") != std::string::npos) {
        throw InputError(png.string() + ": a plot's path cannot hold the mark ' or a line's end. "
                                        "Choose another --out.");
    }
    std::filesystem::path script = png;
    script.replace_extension(".gp");
    write_file(script, script_text);
    const std::string command =
        "gnuplot " + gnuplot_text(std::filesystem::absolute(script).string());
    // NOLINTNEXTLINE(cert-env33-c): the path is ours, and quoted
    const int status = std::system(command.c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
        throw MachineError(png.string() +
                           ": gnuplot is missing. Install the package gnuplot-nox, "
                           "or draw " +
                           script.string() + " elsewhere.");
    }
    if (status != 0) {
        throw MachineError(png.string() + ": gnuplot does not draw " + script.string() +
                           ", for the reason above.");
    }
}

} // namespace raysteps
