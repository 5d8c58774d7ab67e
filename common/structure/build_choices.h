#pragma once

#include "structure/structure_family.h"

#include <map>
#include <span>
#include <string>

namespace raysteps {

// The options of all builders by name. Several may ask for one of the same name; its meaning then
// has each builder's own values.
std::map<std::string, BuildOption> all_build_options();

// Throws InputError where a value was given that no builder of these structures has an option for:
// it would be passed over in silence.
void check_build_values(const std::map<std::string, std::string>& values,
                        std::span<const std::string> structures);

} // namespace raysteps
