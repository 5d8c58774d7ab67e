#pragma once

#include "program/command.h"

namespace raysteps {

// --view of the chapters that have structures.
void add_view_option(CLI::App& app, std::string& view);

// Shows the camera's rays, traced through the structure of --structure: a view of their hits (a
// part of shaders/view), or the heat map of their visits (cells or nodes) or tests (triangles).
// Or, where --rays is given, traces those. Throws InputError where there is no such view.
void show_trace(const Command& command, const std::string& view);

} // namespace raysteps
