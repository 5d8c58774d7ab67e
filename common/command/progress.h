#pragma once

#include <functional>
#include <string>

namespace raysteps {

// A line that shows how far a long work is, with the time that is left. Only on a terminal: in a
// pipe it is quiet.
std::function<void(double part_done)> show_progress(const std::string& work);

} // namespace raysteps
