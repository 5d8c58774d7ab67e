#pragma once

#include <glm/mat4x4.hpp>
#include <toml++/toml.h>

namespace raysteps {

// Where a [[model]] stands: its `matrix`, or its `scale`, then `rotate`, then `translate`.
// Throws InputError with file, line and column; also for a transform that flattens the model.
glm::mat4 toml_transform(const toml::table& model);

} // namespace raysteps
