#pragma once

#include "scene/obj_file.h"
#include "scene/obj_lines.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raysteps {

// Reads an OBJ text statement by statement and lets through only what tinyobjloader reads rightly:
// left alone it takes `nan` and `V` for nothing, 4294967297 for 1 and a comment for a corner, all
// without a word. What it has no callback for, smoothing groups and material files, is kept here.
class ObjStatements {
public:
    ObjStatements(std::string_view text, const std::filesystem::path& path);

    // The next v, vn, vt, f or usemtl statement with a line end; empty after the last.
    // Throws InputError where a statement cannot be used.
    std::string next();

    // Of the statement that next gave last.
    std::int64_t line() const { return line_.number; }
    std::string where() const { return place(path_, line_.number); }
    int smoothing_group() const { return smoothing_group_; }

    const std::vector<ObjLibrary>& libraries() const { return libraries_; }
    Findings& findings() { return findings_; }

private:
    std::string checked(const std::vector<std::string_view>& words);
    void keep_library();
    void keep_smoothing_group(const std::vector<std::string_view>& words);

    std::filesystem::path path_;
    LineReader lines_;
    TextLine line_;
    int smoothing_group_ = 0;
    std::vector<ObjLibrary> libraries_;
    Findings findings_;
};

} // namespace raysteps
