#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Each package is known in one place. A sentence for each include of its headers elsewhere.
std::vector<std::string> find_scattered_packages(const std::filesystem::path& root);
