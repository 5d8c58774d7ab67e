// Writes a scene with all structures over it as one file for the playground (docs/playground).
//
//     playground_scene SCENE FILE
#include "playground_file.h"

#include "basics/error.h"
#include "basics/file.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "structure/padding.h"

#include <iostream>

using namespace raysteps;

int main(int argc, char** argv) {
    try {
        if (argc != 3) {
            throw InputError("Name a scene and a file: playground_scene SCENE FILE.");
        }
        const Scene scene = load_scene(argv[1], 1.0f);
        const float reach = reach_of(origins_of(scene.camera), scene.corners);
        write_file(argv[2], playground_file(scene, 1.0, list_families(), {.reach = reach}));
    } catch (const Error& error) {
        std::cerr << "playground_scene: " << error.what() << "\n";
        return static_cast<int>(error.code());
    }
    return 0;
}
