#pragma once

#include "support/scratch_folder.h"

#include <filesystem>
#include <string>

// A source tree of a few files, for the known answers of a rule.
class SmallTree {
public:
    explicit SmallTree(const std::string& name) : folder_("architecture_" + name) {}

    void write(const std::string& file, const std::string& text) const {
        std::filesystem::create_directories((folder_ / file).parent_path());
        put_bytes(folder_ / file, text);
    }
    std::filesystem::path root() const { return folder_ / "."; }

private:
    ScratchFolder folder_;
};
