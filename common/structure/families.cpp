#include "structure/families.h"

#include "error/error.h"

namespace raysteps {

// Defined in family_NAME.cpp.
#define FAMILY(name) StructureFamily family_##name();
#include <structure_families.inc>
#undef FAMILY

std::vector<StructureFamily> list_families() {
    std::vector<StructureFamily> families;
#define FAMILY(name) families.push_back(family_##name());
#include <structure_families.inc>
#undef FAMILY
    return families;
}

StructureFamily family_of(const std::string& structure) {
    for (StructureFamily& family : list_families()) {
        if (structure == family.name || structure.starts_with(family.name + "_")) {
            return std::move(family);
        }
    }
    throw InputError("--structure " + structure +
                     ": there is no builder for it. See the names with --help.");
}

} // namespace raysteps
