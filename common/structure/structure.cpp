#include "structure/structure.h"

#include "basics/error.h"
#include "basics/text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

namespace raysteps {

namespace {

// 0.0398 of "s" is 39.8 ms. The scales go down; below the last one stands the last.
struct Scale {
    double size;
    const char* unit;
};

template <std::size_t Count>
std::string scaled(double value, const std::array<Scale, Count>& scales) {
    const auto fitting = std::find_if(scales.begin(), scales.end() - 1,
                                      [&](const Scale& scale) { return value >= scale.size; });
    return readable(value / fitting->size) + " " + fitting->unit;
}

constexpr std::array<Scale, 3> of_time{{{1.0, "s"}, {1e-3, "ms"}, {1e-6, "us"}}};
constexpr std::array<Scale, 4> of_memory{{{1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}, {1.0, "bytes"}}};

} // namespace

std::string readable(const Fact& fact) {
    const std::size_t last = fact.name.rfind('_');
    const std::string unit = last == std::string::npos ? "" : fact.name.substr(last + 1);
    const bool is_time = unit == "seconds";
    const bool is_memory = unit == "bytes";
    std::string name = is_time || is_memory ? fact.name.substr(0, last) : fact.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    if (is_time) {
        return name + " " + scaled(fact.value, of_time);
    }
    return name + " " + (is_memory ? scaled(fact.value, of_memory) : readable(fact.value));
}

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
