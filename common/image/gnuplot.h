#pragma once

#include <filesystem>
#include <string>

namespace raysteps {

// In quotes, for gnuplot and for the shell alike: neither looks into '...' until the next mark.
// Texts lose such marks; paths with one are refused.
std::string gnuplot_text(const std::string& text);

// Runs the script, which draws to the PNG file. It stays beside it as NAME.gp, so that anybody can
// draw it another way. Throws MachineError where gnuplot is missing or refuses, InputError where a
// file cannot be written.
void run_gnuplot(const std::filesystem::path& png, const std::string& script_text);

} // namespace raysteps
