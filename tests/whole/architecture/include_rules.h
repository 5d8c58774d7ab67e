#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Who may include whom (docs/architecture.md). Each function returns a sentence for each fault.

// A module of common/ includes the modules that its add_module names as USES, and itself.
std::vector<std::string> find_undeclared_uses(const std::filesystem::path& root);

// A module that names a use includes it: what is linked only because another module needs it comes
// with that module.
std::vector<std::string> find_dead_uses(const std::filesystem::path& root);

// common/ knows nothing of chapters/ and tests/, a chapter nothing of tests/ and other chapters,
// and shaders are C++ only in the modules geometry and mirror, and in tests.
std::vector<std::string> find_includes_against_the_arrow(const std::filesystem::path& root);
