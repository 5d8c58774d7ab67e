#include "catch.h"
#include "programs.h"

// Exit code 2: the person gave something that cannot be used.

TEST_CASE("an option that no program knows is named", "[command][refusal]") {
    const Workplace workplace("unknown_option");
    check_refusals(workplace, {"--nonsense"}, 2, {"--nonsense", "See --help for the options."});
    check_refusals(workplace, {"stray"}, 2, {"stray", "See --help for the options."});
    check_refusals(workplace, {"--size"}, 2, {"--size", "See --help for the options."});
    check_refusal(workplace, "01_rays", {"--triangle", "watertight"}, 2, {"--triangle"});
    check_refusal(workplace, "02_triangles", {"--max-bounces", "1"}, 2, {"--max-bounces"});
}

TEST_CASE("a size that cannot be used is refused by every program", "[command][refusal]") {
    const Workplace workplace("size");
    for (const std::string size : {"0x5", "99999", "ax4", ""}) {
        check_refusals(workplace, {"--size", size}, 2, {"--size " + size + ": ", "640x480"});
    }
}

TEST_CASE("a camera that cannot be used is refused by every program", "[command][refusal]") {
    const Workplace workplace("camera");
    check_refusals(workplace, {"--camera", "1,2,3,4,5"}, 2, {"--camera 1,2,3,4,5", "0,1,5,0,0,0"});
    check_refusals(workplace, {"--camera", "nan,2,3,4,5,6"}, 2, {"--camera nan,2,3,4,5,6"});
    check_refusals(workplace, {"--camera", "1,2,3,1,2,3"}, 2, {"same point", "Move one of them."});
}

TEST_CASE("a context that does not exist is refused with those that do", "[command][refusal]") {
    const Workplace workplace("context");
    check_refusals(workplace, {"--context", "vulkan"}, 2,
                   {"--context vulkan", "auto, osmesa, egl, window"});
}

TEST_CASE("an unknown triangle test is refused with the names of all", "[command][refusal]") {
    const Workplace workplace("triangle");
    for (const std::string chapter : {"02_triangles", "03_shading"}) {
        check_refusal(workplace, chapter, {"--triangle", "best"}, 2,
                      {"--triangle best", "moeller_trumbore, ", "paper_repaired, ",
                       "watertight, watertight_fallback, watertight_rounded."});
    }
}

TEST_CASE("an unknown view is refused with the names of all before any work",
          "[command][refusal]") {
    const Workplace workplace("view");
    // Large enough to run into the time limit if the picture were traced first.
    check_refusal(workplace, "02_triangles",
                  {"--view", "x-ray", "--scene", "knot:64", "--size", "4096"}, 2,
                  {"--view x-ray", "barycentric, depth, facets, hits, normals, triangles."});
}

TEST_CASE("a number of bounces out of range is refused", "[command][refusal]") {
    const Workplace workplace("bounces");
    for (const std::string bounces : {"-1", "1001", "many"}) {
        check_refusal(workplace, "03_shading", {"--max-bounces", bounces}, 2,
                      {"--max-bounces", bounces, "1000"});
    }
}

TEST_CASE("a malformed number, or one out of range, is refused with the range",
          "[command][refusal]") {
    const Workplace workplace("ranges");
    for (const std::string samples : {"-1", "4097", "", "1.5", "0x2"}) {
        check_refusal(workplace, "09_effects", {"--samples", samples}, 2,
                      {"--samples " + samples + ": ", "Give a number from 0 to 4096."});
    }
    for (const std::string part : {"nan", "1.1", "-0.1", "all"}) {
        check_refusal(workplace, "09_effects", {"--faintest", part}, 2,
                      {"--faintest " + part + ": ", "Give a number from 0 to 1."});
    }
}

TEST_CASE("a file that is read is not written", "[command][refusal]") {
    const Workplace workplace("lost_files");
    workplace.write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    check_refusals(workplace, {"--scene", "two.obj", "--json", "two.obj"}, 2,
                   {"--json two.obj: this is the file of --scene, which would be lost."});
}

TEST_CASE("an unknown generation of rays is refused with those that exist", "[command][refusal]") {
    const Workplace workplace("generation");
    check_refusal(workplace, "01_rays", {"--generation", "guessed"}, 2,
                  {"--generation guessed", "interpolated, direct"});
}

TEST_CASE("rays without hits and hits without rays are refused", "[command][refusal]") {
    const Workplace workplace("rays_alone");
    for (const std::string chapter : {"02_triangles", "03_shading"}) {
        check_refusal(workplace, chapter, {"--rays", "r.f32"}, 2, {"--rays and --hits"});
        check_refusal(workplace, chapter, {"--hits", "h.f32"}, 2, {"--rays and --hits"});
    }
}
