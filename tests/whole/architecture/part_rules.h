#pragma once

#include <filesystem>
#include <string>
#include <vector>

// The contract that lets one text be GLSL and C++ (docs/architecture.md, "One text, two
// compilers"). A sentence for each fault.
std::vector<std::string> find_faults_of_parts(const std::filesystem::path& root);

// A pass begins with its version: `#version 410 core`.
std::vector<std::string> find_faults_of_passes(const std::filesystem::path& root);
