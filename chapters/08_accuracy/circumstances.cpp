#include "circumstances.h"

#include "gpu/context.h"

#include <cstdio>
#include <ctime>
#include <memory>

namespace raysteps {

namespace {

// The first line that a command prints; empty where it fails.
std::string line_of(const std::string& command) {
    // NOLINTNEXTLINE(cert-env33-c): the words are ours
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    char line[128] = "";
    if (!pipe || std::fgets(line, sizeof line, pipe.get()) == nullptr) {
        return "";
    }
    std::string text = line;
    while (!text.empty() && text.back() == '\n') {
        text.pop_back();
    }
    return text;
}

std::string commit() {
    const std::string known = line_of("git -C '" RAYSTEPS_SOURCE_DIR
                                      "' describe --always --dirty --abbrev=12 2>/dev/null");
    return known.empty() ? "unknown: no git, or no repository" : known;
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
    return text;
}

} // namespace

Clock clock_of_renderer() {
    const std::string renderer = renderer_name();
    for (const std::string on_processor : {"llvmpipe", "softpipe", "SWR"}) {
        if (renderer.find(on_processor) != std::string::npos) {
            return Clock::processor;
        }
    }
    return Clock::wall;
}

std::vector<std::pair<std::string, std::string>> circumstances_of(const Effort& effort) {
    return {{"date", today()},
            {"renderer", renderer_name()},
            {"time", clock_of_renderer() == Clock::processor
                         ? "processor time of the process, all threads together"
                         : "time on the wall"},
            {"compiler", std::string(RAYSTEPS_COMPILER)},
            {"flags", std::string(RAYSTEPS_FLAGS)},
            {"commit", commit()},
            {"seed", std::to_string(effort.seed)},
            {"rounds", std::to_string(effort.rounds) + ", after one that is dropped; methods take "
                                                       "turns"},
            {"rays of each family", std::to_string(effort.judged_rays) + ", of which " +
                                        std::to_string(effort.timed_rays) + " are timed"}};
}

} // namespace raysteps
