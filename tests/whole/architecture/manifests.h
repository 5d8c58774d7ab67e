#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Which chapter a file came with. A chapter's add_chapter names them as BORN: files and folders. A
// file that is named by itself, or in a deeper folder, is not born with the folder around it.

// Each entry exists, and each file of common/ and shaders/ is born in one chapter.
std::vector<std::string> find_faults_of_manifests(const std::filesystem::path& root);

// A chapter adds files and never edits those of an earlier one. So a file names only files that are
// born with it or before, be it in an #include or as the shader "pass/trace/trace.frag".
std::vector<std::string> find_names_of_the_unborn(const std::filesystem::path& root);
