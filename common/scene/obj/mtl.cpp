#include "scene/obj/mtl.h"

#include "basics/error.h"
#include "basics/file.h"
#include "basics/text.h"
#include "scene/obj/obj_checks.h"
#include "scene/obj/obj_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <system_error>
#include <unordered_set>
#include <vector>

namespace raysteps {

namespace {

enum class OutOfRange { take_nearest, leave_out };

struct Rule {
    std::string_view keyword;
    std::size_t count;
    double least;
    double greatest;
    OutOfRange out_of_range;
};

// Reflectances over 1 make light out of nothing, and facing mirrors then overflow. The ranges of Ni
// and illum are those of the format's description (Wavefront, "MTL material format", 1995); a
// refractive index or a model outside them has no nearest value that would be meant.
constexpr std::array<Rule, 10> rules = {{
    {"Kd", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Ks", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Ke", 3, 0.0, 1e6, OutOfRange::take_nearest},
    {"Kt", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Tf", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Ns", 1, 0.0, 1e6, OutOfRange::take_nearest},
    {"Ni", 1, 0.001, 10.0, OutOfRange::leave_out},
    {"d", 1, 0.0, 1.0, OutOfRange::take_nearest},
    {"Tr", 1, 0.0, 1.0, OutOfRange::take_nearest},
    {"illum", 1, 0.0, 10.0, OutOfRange::leave_out},
}};

const Rule* find_rule(std::string_view keyword) {
    const auto is_of_keyword = [&](const Rule& rule) { return rule.keyword == keyword; };
    const auto rule = std::find_if(rules.begin(), rules.end(), is_of_keyword);
    return rule == rules.end() ? nullptr : &*rule;
}

std::string statement(std::string_view keyword, std::span<const float> values) {
    std::string text(keyword);
    for (const float value : values)
        text += ' ' + shortest_text(value);
    return text + '\n';
}

std::string statement(std::string_view keyword, const glm::vec3& color) {
    return statement(keyword, std::array{color.x, color.y, color.z});
}

std::string renamed_statement(const Rule& rule, std::vector<float> values) {
    if (rule.keyword == "Kt")
        return statement("Tf", values);
    if (rule.keyword == "Tr")
        return statement("d", std::array{1.0f - values[0]});
    return statement(rule.keyword, values);
}

std::string_view last_word_of_path(std::string_view name) {
    const std::size_t slash = name.find_last_of("/\\");
    return slash == std::string_view::npos ? name : name.substr(slash + 1);
}

std::string complaint(const Rule& rule, std::string_view word) {
    return std::string(rule.keyword) + " " + in_quotes(word) + " is not a number between " +
           shortest_text(static_cast<float>(rule.least)) + " and " +
           shortest_text(static_cast<float>(rule.greatest));
}

// The rest of MTL and its later extensions for other kinds of shading. Each is told where it asks
// for something; those of light from all around, which there is none of here, ask for nothing.
constexpr std::array<std::string_view, 26> known_but_not_used = {
    "Km",      "Pc",       "Pcr",      "Pm",     "Pr",       "Ps",       "aniso",
    "anisor",  "bump",     "decal",    "disp",   "map_Bump", "map_Disp", "map_Kt",
    "map_Ks",  "map_Ni",   "map_Ns",   "map_Pm", "map_Pr",   "map_Ps",   "map_Tf",
    "map_aat", "map_bump", "map_disp", "map_Tr", "refl"};
constexpr std::array<std::string_view, 3> of_ambient_light = {"Ka", "map_Ka", "sharpness"};

bool asks_for_nothing(const std::vector<std::string_view>& words) {
    return std::find(of_ambient_light.begin(), of_ambient_light.end(), words.front()) !=
               of_ambient_light.end() ||
           std::all_of(words.begin() + 1, words.end(),
                       [](std::string_view word) { return to_number(word) == 0.0; });
}

bool is_known_keyword_of_mtl(std::string_view keyword) {
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
    else if (keyword == "map_Kd" || keyword == "map_d" || keyword == "map_Ke" || keyword == "norm")
        clean.text.append(keyword).append(" ").append(after_first_word(line.text)).append("\n");
    else if (asks_for_nothing(words))
        return;
    else if (is_known_keyword_of_mtl(keyword))
        note(std::string(keyword) + " is not shown");
    else
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

// One name with spaces in it, where there is such a file; else names that spaces set apart.
std::vector<std::string_view> names_in(const ObjLibrary& library,
                                       const std::filesystem::path& folder) {
    const auto path = path_inside(folder, folder, library.name);
    std::error_code failure;
    if (path && std::filesystem::exists(*path, failure))
        return {library.name};
    return split_words(library.name);
}

bool is_file_inside(const std::filesystem::path& folder, std::string_view name) {
    const auto path = path_inside(folder, folder, name);
    std::error_code failure;
    return path && std::filesystem::is_regular_file(*path, failure);
}

// The name under which a material file is there; the name itself where it is not, and all that were
// tried.
struct FoundLibrary {
    std::string name;
    std::string tried;
};

FoundLibrary found_library(std::string_view name, const std::filesystem::path& obj_path) {
    const std::filesystem::path folder = folder_of(obj_path);
    std::vector<std::string> places{std::string(name)};
    for (const std::string& place :
         {std::string(last_word_of_path(name)), obj_path.stem().string() + ".mtl"})
        if (std::find(places.begin(), places.end(), place) == places.end())
            places.push_back(place);
    std::string tried;
    for (const std::string& place : places) {
        if (is_file_inside(folder, place))
            return {place, ""};
        tried += (tried.empty() ? "" : ", ") + (folder / place).string();
    }
    return {std::string(name), tried};
}

// A reason as the end of a sentence.
std::string without_full_stop(std::string text) {
    while (text.ends_with('.'))
        text.pop_back();
    return text;
}

// The file's text, or why it cannot be had.
struct Outcome {
    std::string text;
    std::string problem;
};

Outcome read_mtl_file(const std::filesystem::path& path) {
    try {
        Outcome outcome{read_file(path, most_mtl_bytes), ""};
        check_is_text(outcome.text, path);
        return outcome;
    } catch (const InputError& error) {
        return {"", error.what()};
    }
}

} // namespace

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::optional<std::filesystem::path> path_inside(const std::filesystem::path& inside,
                                                 const std::filesystem::path& from,
                                                 std::string_view name) {
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const std::filesystem::path named(slashed);
    if (named.empty())
        return std::nullopt;
    const std::filesystem::path path = (from / named).lexically_normal();

    std::error_code failure;
    const std::filesystem::path root = std::filesystem::weakly_canonical(inside, failure);
    if (failure)
        return std::nullopt;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, failure);
    if (failure)
        return std::nullopt;
    const std::filesystem::path way = target.lexically_relative(root);
    if (way.empty() || *way.begin() == "..")
        return std::nullopt;
    return path;
}

MtlTexture find_texture(const std::string& name, const std::filesystem::path& mtl_path,
                        const std::filesystem::path& inside) {
    if (name.empty())
        return {};
    const std::filesystem::path folder = folder_of(mtl_path);
    const std::string last(last_word_of_path(name));
    std::string tried;
    for (const std::string& place : {name, last, "textures/" + last}) {
        const auto path = path_inside(inside, folder, place);
        std::error_code failure;
        if (path && std::filesystem::exists(*path, failure))
            return {path->string(), ""};
        const std::string text = path ? path->string() : place + " (outside the model's folder)";
        if (tried.find(text) == std::string::npos)
            tried += (tried.empty() ? "" : ", ") + text;
    }
    const auto path = path_inside(inside, folder, name);
    const std::string what = path ? ": There is no texture " + in_quotes(name) + "."
                                  : ": The texture " + in_quotes(name) +
                                        " is not in the folder of the model, so it is left out.";
    return {path ? path->string() : "", mtl_path.string() + what + " Tried: " + tried + "."};
}

bool has_mtl_values(std::string_view keyword) {
    return find_rule(keyword) != nullptr;
}

MtlValues checked_mtl_values(const std::vector<std::string_view>& words) {
    const Rule& rule = *find_rule(words.front());
    MtlValues result;
    std::vector<float> values;
    for (std::size_t i = 1; i <= rule.count; ++i) {
        const bool is_grey = words.size() == 2;
        const std::string_view word = is_grey ? words[1] : i < words.size() ? words[i] : "";
        const double number = to_number(word).value_or(std::nan(""));
        const bool is_right = number >= rule.least && number <= rule.greatest;
        const bool is_hopeless = std::isnan(number) || rule.out_of_range == OutOfRange::leave_out;
        if (!is_right && is_hopeless)
            return {"", complaint(rule, word) + ", so the line was left out"};
        const auto value = static_cast<float>(std::clamp(number, rule.least, rule.greatest));
        if (!is_right)
            result.correction = complaint(rule, word) + ", so " + shortest_text(value) + " is used";
        values.push_back(value);
    }
    result.statement = renamed_statement(rule, values);
    return result;
}

std::string to_mtl(const Material& material) {
    return "newmtl " + material.name + '\n' + statement("Kd", material.diffuse) +
           statement("Ks", material.specular) + statement("Ke", material.emission) +
           statement("Tf", material.transmission) + "Ns " + shortest_text(material.shininess) +
           "\nNi " + shortest_text(material.refractive_index) + "\nd " +
           shortest_text(material.opacity) + "\nillum " +
           std::to_string(material.illumination_model) + '\n';
}

CleanMtl clean_mtl(std::string_view text) {
    LineReader lines(text);
    MtlCleaner cleaner;
    while (const std::optional<TextLine> line = lines.next())
        cleaner.take(*line);
    return std::move(cleaner.clean);
}

MtlFiles read_mtl_files(const ObjFile& file) {
    MtlFiles result;
    std::set<std::filesystem::path> seen;
    const std::filesystem::path folder = folder_of(file.path);
    for (const ObjLibrary& library : file.libraries) {
        for (const std::string_view named : names_in(library, folder)) {
            const auto [name, tried] = found_library(named, file.path);
            if (name != named)
                result.findings.note("The material file " + in_quotes(named) +
                                         " is not there, so " + in_quotes(name) + " was read",
                                     library.line);
            const auto path = path_inside(folder, folder, name);
            if (!path) {
                result.findings.note("The material file " + in_quotes(name) +
                                         " is not in the folder of the model, so it was not read",
                                     library.line);
                continue;
            }
            if (!seen.insert(*path).second)
                continue;
            Outcome outcome = read_mtl_file(*path);
            if (outcome.problem.empty())
                result.files.push_back({*path, std::move(outcome.text)});
            else
                result.findings.note("The material file " + in_quotes(name) +
                                         " was not read, because " +
                                         without_full_stop(outcome.problem) +
                                         (tried.empty() ? "" : " (tried " + tried + ")"),
                                     library.line);
        }
    }
    return result;
}

} // namespace raysteps
