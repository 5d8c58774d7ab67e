#include "structure/structure.h"

#include "basics/error.h"

#include <algorithm>
#include <set>

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

std::map<std::string, BuildOption> all_build_options() {
    // Families that say the same of an option are named together: "bvh, half_bvh: ... (32)".
    std::map<std::string, std::vector<std::pair<std::string, std::string>>> families_of_meaning;
    std::map<std::string, BuildOption> merged;
    for (const StructureFamily& family : list_families()) {
        for (const BuildOption& option : family.options) {
            merged.try_emplace(option.name, option);
            const std::string meaning = option.meaning + " (" + option.initial + ")";
            auto& known = families_of_meaning[option.name];
            const auto same = std::find_if(known.begin(), known.end(), [&](const auto& pair) {
                return pair.second == meaning;
            });
            if (same == known.end()) {
                known.emplace_back(family.name, meaning);
            } else {
                same->first += ", " + family.name;
            }
        }
    }
    for (auto& [name, option] : merged) {
        option.meaning.clear();
        for (const auto& [families, meaning] : families_of_meaning[name]) {
            option.meaning += (option.meaning.empty() ? "" : "; ") + families + ": " + meaning;
        }
    }
    return merged;
}

void check_build_values(const std::map<std::string, std::string>& values,
                        std::span<const std::string> structures) {
    std::string names;
    std::string options;
    std::set<std::string> known;
    for (const std::string& structure : structures) {
        names += (names.empty() ? "" : ", ") + structure;
        for (const BuildOption& option : family_of(structure).options) {
            if (known.insert(option.name).second) {
                options += (options.empty() ? "--" : ", --") + option.name;
            }
        }
    }
    for (const auto& [name, value] : values) {
        if (!known.contains(name)) {
            throw InputError("--" + name + " " + value + ": not an option of " + names +
                             (options.empty() ? ", which has none. Leave it out, or choose another "
                                                "--structure."
                                              : ". Take one of " + options + "."));
        }
    }
}

} // namespace raysteps
