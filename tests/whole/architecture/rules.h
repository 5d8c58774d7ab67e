#pragma once

#include <filesystem>
#include <string>
#include <vector>

// The rules of docs/architecture.md and docs/style.md. Each function returns a sentence for each
// fault.

// A module of common/ includes the modules that its add_module names as USES, and itself.
std::vector<std::string> find_undeclared_uses(const std::filesystem::path& root);

// A module that names a use includes it: what is linked only because another module needs it comes
// with that module.
std::vector<std::string> find_dead_uses(const std::filesystem::path& root);

// The table of modules in docs/architecture.md has a row for each module, which allows all that its
// USES names.
std::vector<std::string> find_uses_beyond_the_table(const std::filesystem::path& root);

// common/ knows nothing of what is built on it, a chapter nothing of other chapters, nothing knows
// tests/, and shaders are C++ only in the modules basics, structure and mirror, and in tests.
std::vector<std::string> find_includes_against_the_arrow(const std::filesystem::path& root);

// Each package is known in one place: a sentence for each include of its headers elsewhere.
std::vector<std::string> find_scattered_packages(const std::filesystem::path& root);

// The sources, tests apart, that include the package's header, be it through headers of ours.
std::vector<std::string> list_sources_that_see(const std::filesystem::path& root,
                                               const std::string& header);

// The headers of common/ that only one file includes, its own source and tests apart: they could
// stand in that file.
std::vector<std::string> list_headers_of_one_file(const std::filesystem::path& root);

// A type, or an inline function with its parameters, is defined once in its namespace: a program
// that links two of one name does whatever the linker took.
std::vector<std::string> find_double_names(const std::filesystem::path& root);

// What CTest runs is found by its name: a file with tests is called x_test.cpp.
std::vector<std::string> find_misnamed_tests(const std::filesystem::path& root);

// The contract that lets one text be GLSL and C++ (docs/architecture.md, "One text, two
// compilers").
std::vector<std::string> find_faults_of_parts(const std::filesystem::path& root);

// A pass begins with its version: `#version 410 core`.
std::vector<std::string> find_faults_of_passes(const std::filesystem::path& root);
