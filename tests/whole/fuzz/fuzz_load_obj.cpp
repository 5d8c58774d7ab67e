// Whatever the bytes are, as an OBJ, MTL or PLY file and as what the importer hands over they end
// in a sound scene or in an InputError. Anything else stops the program, and libFuzzer keeps the
// bytes.
#include "modules/load_obj/first_fault.h"

#include "basics/error.h"
#include "scene/import/mesh_file.h"
#include "scene/obj/load_obj.h"
#include "scene/ply/load_ply.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

void demand(const std::string& fault) {
    if (fault.empty())
        return;
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
}

void try_obj(std::string_view text) {
    try {
        demand(first_fault(raysteps::parse_obj(text, RAYSTEPS_CORPUS "/fuzz.obj")));
    } catch (const raysteps::InputError&) {
    }
}

void try_mtl(std::string_view text) {
    try {
        const std::filesystem::path path = RAYSTEPS_CORPUS "/fuzz.mtl";
        for (const auto& material : raysteps::parse_mtl(text, path, RAYSTEPS_CORPUS).materials)
            demand(first_fault(material));
    } catch (const raysteps::InputError&) {
    }
}

void try_ply(std::string_view bytes) {
    try {
        demand(first_fault(
            raysteps::parse_ply(bytes, RAYSTEPS_CORPUS "/fuzz.ply", raysteps::Origin::near_model)));
    } catch (const raysteps::InputError&) {
    }
}

void try_mesh_file(std::string_view bytes) {
    try {
        for (const auto& material : raysteps::read_mesh_file(bytes, "fuzz").materials)
            demand(material.opacity >= 0 && material.opacity <= 1 ? "" : "an opacity is no part");
    } catch (const raysteps::InputError&) {
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    try_obj(text);
    try_mtl(text);
    try_ply(text);
    try_mesh_file(text);
    return 0;
}
