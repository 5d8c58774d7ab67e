#include "catch.h"
#include "programs.h"

namespace {

void check_help(const std::string& chapter, const std::vector<std::string>& options) {
    const Workplace workplace("help_" + chapter);
    for (const std::string word : {"--help", "-h"}) {
        const Outcome outcome = workplace.run(chapter, {word});
        CAPTURE(chapter, word);
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.errors.empty());
        for (const std::string& option : options) {
            CHECK_THAT(outcome.output,
                       contains_text("  " + option + " ") || contains_text("  " + option + ","));
        }
    }
    CHECK(workplace.list_files().empty());
}

const std::vector<std::string> common_options{"--scene",  "--size",        "--camera",
                                              "--out",    "--json",        "--context",
                                              "--window", "--print-scene", "--list-scenes"};

std::vector<std::string> with(std::vector<std::string> options,
                              const std::vector<std::string>& more) {
    options.insert(options.end(), more.begin(), more.end());
    return options;
}

} // namespace

TEST_CASE("help names every option of every program", "[command]") {
    const std::vector<std::string> tracing =
        with(common_options,
             {"--triangle", "--structure", "--rays", "--hits", "--density", "--split", "--tree"});
    check_help("01_rays", with(common_options, {"--generation"}));
    check_help("02_triangles", with(tracing, {"--view", "--exhibit"}));
    check_help("03_shading", with(tracing, {"--max-bounces"}));
    check_help("04_grid", with(tracing, {"--view", "--measure", "--plot"}));
    check_help("05_kd_tree", with(tracing, {"--view", "--measure"}));
    check_help("06_bvh", with(tracing, {"--view", "--measure"}));
    check_help("07_compare", with(tracing, {"--scenes", "--growth", "--rounds", "--most-seconds",
                                            "--embree", "--against", "--gpu-cards"}));
    check_help("08_accuracy", with(common_options, {"--quick", "--full", "--trade-offs,--knobs",
                                                    "--seed", "--rounds"}));
    check_help("09_effects", with(tracing, {"--effects", "--max-bounces", "--faintest", "--samples",
                                            "--explain", "--prove", "--scenes", "--rounds"}));
    check_help("10_speed",
               with(common_options, {"--scenes", "--full", "--rounds", "--embree", "--tree"}));
    check_help("11_paths",
               with(common_options, {"--structure", "--samples", "--seconds", "--error", "--random",
                                     "--bounce", "--heuristic", "--roulette", "--max-bounces",
                                     "--seed", "--exposure", "--jobs-file", "--merge"}));
    check_help("check", {"--tree", "--scene", "--rays", "--judge", "--why", "--export", "--json"});
}

TEST_CASE("every program says which version it is", "[command]") {
    const Workplace workplace("version");
    for (const std::string program : {"01_rays", "07_compare", "hard_cases", "check"}) {
        const Outcome outcome = workplace.run(program, {"--version"});
        CAPTURE(program);
        CHECK(outcome.exit_code == 0);
        CHECK_THAT(outcome.output, starts_with_text("Raysteps 0.1.0, commit "));
    }
    CHECK(workplace.list_files().empty());
}

TEST_CASE("of an option that is given twice the last counts", "[command]") {
    const Workplace workplace("twice");
    const Outcome outcome =
        workplace.run("01_rays", {"--scene", "lost", "--scene", "cornell_box", "--print-scene"});
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.output, starts_with_text("sample = \"cornell_box\""));
}
