#include "scene/obj_statements.h"

#include "scene/obj_checks.h"
#include "scene/obj_numbers.h"

#include <algorithm>
#include <array>
#include <limits>

namespace raysteps {

namespace {

// What OBJ has beside polygons: groups, lines, points, free-form curves and surfaces, and display
// attributes (Wavefront, "Object files (.obj)", Advanced Visualizer manual, appendix B1, 1995).
constexpr std::array<std::string_view, 38> known_but_not_drawn = {
    "bevel", "bmat", "bsp",    "bzp",       "c_interp",   "call",   "cdc",      "cdp",
    "con",   "csh",  "cstype", "ctech",     "curv",       "curv2",  "d_interp", "deg",
    "end",   "g",    "hole",   "l",         "lod",        "maplib", "mg",       "o",
    "p",     "parm", "res",    "scrv",      "shadow_obj", "sp",     "stech",    "step",
    "surf",  "t",    "trim",   "trace_obj", "usemap",     "vp"};

bool is_known(std::string_view keyword) {
    return std::find(known_but_not_drawn.begin(), known_but_not_drawn.end(), keyword) !=
           known_but_not_drawn.end();
}

} // namespace

ObjStatements::ObjStatements(std::string_view text, const std::filesystem::path& path)
    : path_(path), lines_(text) {}

std::string ObjStatements::next() {
    while (const std::optional<TextLine> line = lines_.next()) {
        line_ = *line;
        const std::vector<std::string_view> words = split_values(line_.text);
        std::string statement = words.empty() ? std::string{} : checked(words);
        if (!statement.empty())
            return statement;
    }
    return {};
}

std::string ObjStatements::checked(const std::vector<std::string_view>& words) {
    const std::string_view keyword = words.front();
    if (keyword == "v")
        return checked_vertex(words, where());
    if (keyword == "vt")
        return checked_texture_coordinate(words, where());
    if (keyword == "vn")
        return checked_normal(words);
    if (keyword == "f" && words.size() >= 4)
        return checked_face(words, where());
    if (keyword == "usemtl")
        return "usemtl " + std::string(after_first_word(line_.text)) + '\n';
    if (keyword == "mtllib")
        keep_library();
    else if (keyword == "s")
        keep_smoothing_group(words);
    else if (keyword == "f")
        findings_.note("A face with fewer than three corners was dropped", line_.number);
    else if (!is_known(keyword))
        findings_.note("OBJ has no statement " + in_quotes(keyword) +
                           " (its own are in small letters), so the line was skipped",
                       line_.number);
    return {};
}

void ObjStatements::keep_library() {
    const std::string_view name = after_first_word(line_.text);
    if (name.empty())
        findings_.note("mtllib names no material file, so it was skipped", line_.number);
    else
        libraries_.push_back({std::string(name), line_.number});
}

void ObjStatements::keep_smoothing_group(const std::vector<std::string_view>& words) {
    const std::string_view word = words.size() > 1 ? words[1] : std::string_view{};
    const std::int64_t number = to_whole_number(word).value_or(-1);
    smoothing_group_ = 0;
    if (word == "on")
        smoothing_group_ = 1;
    else if (number >= 0 && number <= std::numeric_limits<int>::max())
        smoothing_group_ = static_cast<int>(number);
    else if (word != "off")
        findings_.note("There is no smoothing group " + in_quotes(word) +
                           ", so smoothing was set off",
                       line_.number);
}

} // namespace raysteps
