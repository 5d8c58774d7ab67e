// Whatever the bytes are, as an OBJ file and as an MTL file they end in a sound scene or in an
// InputError. Anything else stops the program, and libFuzzer keeps the bytes.
#include "modules/load_obj/first_fault.h"

#include "basics/error.h"
#include "scene/obj/load_obj.h"

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

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    try_obj(text);
    try_mtl(text);
    return 0;
}
