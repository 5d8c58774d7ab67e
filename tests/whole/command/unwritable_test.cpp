#include "catch.h"
#include "programs.h"
#include "ray_bytes.h"

TEST_CASE("a folder that cannot be made is refused and leaves no file", "[command][refusal]") {
    const Workplace workplace("unwritable_out");
    workplace.write("file", "a file where a folder is needed");
    check_refusals(workplace, {"--scene", "cornell_box", "--size", "8x6", "--out", "file/pictures"},
                   2, {"file/pictures/", "cannot be written", "Choose another path"});
    CHECK(workplace.read("file") == "a file where a folder is needed");
}

TEST_CASE("numbers that cannot be written are refused and leave no partial file",
          "[command][refusal]") {
    const Workplace workplace("unwritable_json");
    workplace.write("file", "");
    std::filesystem::create_directory(workplace / "folder");
    for (const std::string& chapter : chapters) {
        std::vector<std::string> options{"--scene", "cornell_box", "--size", "8x6",
                                         "--out",   "pictures",    "--json", "folder"};
        workplace.run(chapter, options); // so that the pictures are no new files
        for (const std::string json : {"file/numbers.json", "folder", "/dev/null"}) {
            options.back() = json;
            check_refusal(workplace, chapter, options, 2, {json, "cannot be written"});
        }
    }
}

TEST_CASE("hits that cannot be written are refused", "[command][refusal]") {
    const Workplace workplace("unwritable_hits");
    workplace.write("file", "");
    workplace.write("rays.f32", ray_bytes({{0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f}}));
    check_refusal(workplace, "02_triangles",
                  {"--scene", "cornell_box", "--rays", "rays.f32", "--hits", "file/hits.csv"}, 2,
                  {"file/hits.csv", "cannot be written"});
}

TEST_CASE("an output that is cut short is an error", "[command][refusal]") {
    if (!std::filesystem::exists("/dev/full")) {
        WARN("This system has no /dev/full, so nothing is checked.");
        return;
    }
    const Workplace workplace("unwritable_output");
    for (const std::string& chapter : chapters) {
        for (const std::string question : {"--list-scenes", "--print-scene"}) {
            const Outcome outcome = workplace.run_into("/dev/full", chapter, {question});
            CAPTURE(chapter, question);
            CHECK(outcome.exit_code == 2);
            CHECK_THAT(outcome.errors, starts_with_text(chapter + ": standard output cannot be"));
        }
    }
}

// Exit code 3: the machine lacks something.

TEST_CASE("a window without a display is refused with the exit code 3", "[command][refusal]") {
    const Workplace workplace("no_display");
    for (const std::string& chapter : chapters) {
        const bool makes_a_page = chapter == "08_accuracy"; // which a window cannot show
        check_refusal(workplace, chapter, {"--scene", "cornell_box", "--window"},
                      makes_a_page ? 2 : 3, {makes_a_page ? "--window: " : "window: "});
    }
    check_refusals(workplace, {"--scene", "cornell_box", "--context", "window"}, 3, {"window: "});
}
