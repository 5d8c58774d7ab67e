#include "structure/structure.h"

#include "basics/error.h"
#include "basics/text.h"

#include <algorithm>
#include <iostream>
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

namespace {

// The one place that says which walk is the fastest: chapter 07 measures it.
const std::string fastest_walk = "packet_bvh4";
const std::string packet_prefix = "packet_";

const std::string& full_name(const std::string& structure) {
    return structure == "fastest" ? fastest_walk : structure;
}

} // namespace

bool has_packets(const std::string& structure) {
    return full_name(structure).starts_with(packet_prefix);
}

std::string single_walk(const std::string& structure) {
    const std::string& name = full_name(structure);
    return has_packets(name) ? name.substr(packet_prefix.size()) : name;
}

StructureFamily family_of(const std::string& structure) {
    const std::string walk = single_walk(structure);
    for (StructureFamily& family : list_families()) {
        if (walk == family.name || walk.starts_with(family.name + "_")) {
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
            const std::string meaning =
                option.meaning + (option.initial.empty() ? "" : " (" + option.initial + ")");
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

void print_warning(const std::string& sentence) {
    std::cerr << sentence << "\n";
}

std::map<std::string, std::string>
used_build_values(const std::string& structure, const std::map<std::string, std::string>& values) {
    std::map<std::string, std::string> used;
    for (const BuildOption& option : family_of(structure).options) {
        const auto given = values.find(option.name);
        used[option.name] = given != values.end() ? given->second : option.initial;
    }
    return used;
}

StructureChoice parse_structure(const std::string& text) {
    const std::vector<std::string> words = split_words(text, ':');
    StructureChoice choice{.text = text, .structure = words.front()};
    for (auto word = words.begin() + 1; word != words.end(); ++word) {
        const std::size_t sign = word->find('=');
        if (sign == 0 || sign == std::string::npos) {
            throw InputError("--structure " + text + ": `" + *word +
                             "` is no option and its value. Write NAME:option=value, and more "
                             "options behind further colons.");
        }
        if (!choice.values.emplace(word->substr(0, sign), word->substr(sign + 1)).second) {
            throw InputError("--structure " + text + ": the option " + word->substr(0, sign) +
                             " is given twice. Give it once.");
        }
    }
    check_build_values(choice.values, {{choice.structure}});
    return choice;
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
