#include "catch.h"
#include "programs.h"

TEST_CASE("a scene that is not there is refused", "[command][refusal]") {
    const Workplace workplace("scene_missing");
    std::filesystem::create_directory(workplace / "models");
    std::filesystem::create_directory(workplace / "models.obj");
    check_refusals(workplace, {"--scene", "bunny.obj"}, 2, {"bunny.obj: there is no such file"});
    check_refusals(workplace, {"--scene", "bunny.toml"}, 2, {"bunny.toml: there is no such file"});
    check_refusals(workplace, {"--scene", "models"}, 2, {"models: this is a folder", ".obj"});
    check_refusals(workplace, {"--scene", "models.obj"}, 2, {"models.obj", "folder"});
    check_refusals(workplace, {"--scene", "mirors"}, 2,
                   {"\"mirors\"", "Did you mean mirrors?", "--list-scenes"});
    check_refusals(workplace, {"--scene", "sphereflake:99"}, 2, {"0 to 5, not \"99\""});
}

TEST_CASE("a model with a fault is refused with its line", "[command][refusal]") {
    const Workplace workplace("scene_obj");
    workplace.write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    workplace.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
    check_refusals(workplace, {"--scene", "far.obj"}, 2, {"far.obj:4: ", "9"});
    check_refusals(workplace, {"--scene", "nan.obj"}, 2, {"nan.obj:2: "});
}

TEST_CASE("a scene file with a fault is refused with its line", "[command][refusal]") {
    const Workplace workplace("scene_toml");
    workplace.write("key.toml", "sample = \"mirrors\"\nfog = 1\n");
    workplace.write("syntax.toml", "sample = \"mirrors\nlight = []\n");
    workplace.write("model.toml", "[[model]]\npath = \"lost.obj\"\n");
    check_refusals(workplace, {"--scene", "key.toml"}, 2, {"key.toml:2:", "fog"});
    check_refusals(workplace, {"--scene", "syntax.toml"}, 2, {"syntax.toml:1:"});
    check_refusals(workplace, {"--scene", "model.toml"}, 2, {"model.toml:2:", "lost.obj"});
}
