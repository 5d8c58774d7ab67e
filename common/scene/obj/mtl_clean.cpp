#include "scene/mtl_clean.h"

#include "scene/mtl_values.h"
#include "scene/obj_lines.h"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <vector>

namespace raysteps {

namespace {

// The rest of MTL and its later extensions for other kinds of shading.
constexpr std::array<std::string_view, 32> known_but_not_used = {
    "Ka",      "Km",       "Pc",     "Pcr",      "Pm",       "Pr",       "Ps",     "aniso",
    "anisor",  "bump",     "decal",  "disp",     "map_Bump", "map_Disp", "map_Ka", "map_Ke",
    "map_Kt",  "map_Ks",   "map_Ni", "map_Ns",   "map_Pm",   "map_Pr",   "map_Ps", "map_Tf",
    "map_aat", "map_bump", "map_d",  "map_disp", "map_Tr",   "norm",     "refl",   "sharpness"};

bool is_known(std::string_view keyword) {
    return std::find(known_but_not_used.begin(), known_but_not_used.end(), keyword) !=
           known_but_not_used.end();
}

class MtlCleaner {
public:
    void take(const TextLine& line);

    CleanMtl clean;

private:
    void begin_material(std::string_view name);
    void take_values(const std::vector<std::string_view>& words);
    void note(const std::string& sentence) { clean.findings.note(sentence, line_); }

    std::unordered_set<std::string> names_;
    std::string name_;
    std::int64_t line_ = 0;
    bool has_opacity_ = false;
};

void MtlCleaner::take(const TextLine& line) {
    line_ = line.number;
    const std::vector<std::string_view> words = split_values(line.text);
    if (words.empty())
        return;
    const std::string_view keyword = words.front();
    if (keyword == "newmtl")
        begin_material(after_first_word(line.text));
    else if (names_.empty())
        note("A line before the first newmtl belongs to no material, so it was left out");
    else if (has_mtl_values(keyword))
        take_values(words);
    else if (keyword == "map_Kd")
        clean.text.append("map_Kd ").append(after_first_word(line.text)).append("\n");
    else if (!is_known(keyword))
        note("MTL has no statement " + in_quotes(keyword) + ", so the line was left out");
}

void MtlCleaner::begin_material(std::string_view name) {
    Material material;
    if (name.empty())
        note("newmtl gives no name, so the material is called \"default\"");
    else
        material.name = name;
    if (!names_.insert(material.name).second)
        note("Material " + in_quotes(material.name) + " is made twice, so the first one is used");
    name_ = material.name;
    has_opacity_ = false;
    clean.text += to_mtl(material);
}

// Where a material has both, d counts: programs disagree whether Tr is 1 - d or d.
void MtlCleaner::take_values(const std::vector<std::string_view>& words) {
    if (words.front() == "Tr" && has_opacity_)
        return;
    has_opacity_ = has_opacity_ || words.front() == "d";
    const MtlValues values = checked_mtl_values(words);
    clean.text += values.statement;
    if (!values.correction.empty())
        note("In material " + in_quotes(name_) + ", " + values.correction);
}

} // namespace

CleanMtl clean_mtl(std::string_view text) {
    LineReader lines(text);
    MtlCleaner cleaner;
    while (const std::optional<TextLine> line = lines.next())
        cleaner.take(*line);
    return std::move(cleaner.clean);
}

} // namespace raysteps
