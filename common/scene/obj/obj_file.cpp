#include "scene/obj/obj_file.h"

#include "basics/error.h"
#include "basics/text.h"
#include "scene/obj/obj_checks.h"
#include "scene/scaling.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace raysteps {

namespace {

constexpr std::size_t most_kinds = 50;
constexpr std::size_t most_lines = 5;

std::string listed(const std::vector<std::int64_t>& lines) {
    std::string text;
    for (const std::int64_t line : lines)
        text += (text.empty() ? "" : ", ") + std::to_string(line);
    return text;
}

// from_chars reads no '+', which OBJ allows; but "+-1" is no number.
std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view spaces = " \t\v\f";

bool ends_line(char character) {
    return character == '\n' || character == '\r';
}

bool joins_next(std::string_view line) {
    return !line.empty() && line.back() == '\\';
}

bool is_comment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(spaces);
    return first != std::string_view::npos && line[first] == '#';
}

} // namespace

std::string place(const std::filesystem::path& path, std::int64_t line) {
    return path.string() + ":" + std::to_string(line) + ": ";
}

void ObjFindings::note(const std::string& sentence, std::int64_t line) {
    const bool is_full = findings_.size() >= most_kinds && !index_of_sentence_.contains(sentence);
    const std::string& kind = is_full ? "There is more of other kinds" : sentence;
    const auto [entry, is_new] = index_of_sentence_.try_emplace(kind, findings_.size());
    if (is_new)
        findings_.push_back({kind, 0, {}});
    Finding& finding = findings_[entry->second];
    ++finding.count;
    if (finding.first_lines.size() < most_lines)
        finding.first_lines.push_back(line);
}

std::vector<std::string> ObjFindings::sentences(const std::filesystem::path& path,
                                                FindingsCount counts) const {
    const bool by_face = counts == FindingsCount::faces;
    std::vector<std::string> sentences;
    for (const Finding& finding : findings_) {
        const std::int64_t first = finding.first_lines.front();
        std::string sentence = (by_face ? path.string() + ": face " + std::to_string(first) + ": "
                                        : place(path, first)) +
                               finding.sentence;
        if (finding.count > 1)
            sentence += ", " + std::to_string(finding.count) + " times (" +
                        (by_face ? "faces " : "lines ") + listed(finding.first_lines) +
                        (finding.count > static_cast<std::int64_t>(most_lines) ? ", ...)" : ")");
        sentences.push_back(sentence + ".");
    }
    return sentences;
}

std::optional<double> to_number(std::string_view word) {
    word = without_plus(word);
    double number = 0.0;
    const char* const end = word.data() + word.size();
    const auto [stop, failure] = std::from_chars(word.data(), end, number);
    if (failure == std::errc::invalid_argument || stop != end)
        return std::nullopt;
    if (failure == std::errc::result_out_of_range)
        return std::numeric_limits<double>::infinity();
    return number;
}

std::optional<std::int64_t> to_whole_number(std::string_view word) {
    return parse_number<std::int64_t>(without_plus(word));
}

LineReader::LineReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with(byte_order_mark))
        rest_.remove_prefix(byte_order_mark.size());
}

std::optional<TextLine> LineReader::next() {
    if (rest_.empty())
        return std::nullopt;
    const std::string_view first = take_line();
    const std::int64_t number = lines_taken_;
    if (is_comment(first) || !joins_next(first))
        return TextLine{number, first};
    joined_ = first;
    while (joins_next(joined_)) {
        joined_.back() = ' ';
        if (rest_.empty())
            break;
        joined_ += take_line();
    }
    return TextLine{number, joined_};
}

std::string_view LineReader::take_line() {
    const auto end = std::find_if(rest_.begin(), rest_.end(), ends_line);
    const std::string_view line = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(line.size());
    if (rest_.starts_with("\r\n"))
        rest_.remove_prefix(2);
    else if (!rest_.empty())
        rest_.remove_prefix(1);
    ++lines_taken_;
    return line;
}

std::vector<std::string_view> split_words(std::string_view text) {
    std::vector<std::string_view> words;
    words.reserve(8);
    std::size_t start = text.find_first_not_of(spaces);
    while (start != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(spaces, start), text.size());
        words.push_back(text.substr(start, end - start));
        start = text.find_first_not_of(spaces, end);
    }
    return words;
}

std::vector<std::string_view> split_values(std::string_view text) {
    std::vector<std::string_view> words = split_words(text);
    const auto starts_comment = [](std::string_view word) { return word.starts_with('#'); };
    words.erase(std::find_if(words.begin(), words.end(), starts_comment), words.end());
    return words;
}

std::string_view after_first_word(std::string_view text) {
    const std::size_t word = std::min(text.find_first_not_of(spaces), text.size());
    const std::size_t word_end = std::min(text.find_first_of(spaces, word), text.size());
    const std::size_t start = std::min(text.find_first_not_of(spaces, word_end), text.size());
    const std::size_t last = text.find_last_not_of(spaces);
    return start == text.size() ? std::string_view{} : text.substr(start, last + 1 - start);
}

namespace {

// What OBJ has beside polygons: groups, lines, points, free-form curves and surfaces, and display
// attributes (Wavefront, "Object files (.obj)", Advanced Visualizer manual, appendix B1, 1995).
constexpr std::array<std::string_view, 36> known_but_not_drawn = {
    "bevel", "bmat",      "bsp",        "bzp",   "c_interp", "call",  "cdc",      "cdp",
    "con",   "csh",       "cstype",     "ctech", "curv",     "curv2", "d_interp", "deg",
    "end",   "hole",      "l",          "lod",   "maplib",   "mg",    "p",        "parm",
    "res",   "scrv",      "shadow_obj", "sp",    "stech",    "step",  "surf",     "t",
    "trim",  "trace_obj", "usemap",     "vp"};

bool is_known_keyword_of_obj(std::string_view keyword) {
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
    if (keyword == "vt")
        return checked_texture_coordinate(words, where());
    if (keyword == "vn")
        return checked_normal(words);
    face_number_ += keyword == "f" ? 1 : 0;
    if (keyword == "f" && words.size() >= 4)
        return checked_face(words, where());
    if (keyword == "usemtl")
        return "usemtl " + std::string(after_first_word(line_.text)) + '\n';
    if (keyword == "v")
        keep_vertex(words);
    else if (keyword == "mtllib")
        keep_library();
    else if (keyword == "o" || keyword == "g")
        keep_object();
    else if (keyword == "s")
        keep_smoothing_group(words);
    else if (keyword == "f")
        findings_.note("A face with fewer than three corners was dropped", line_.number);
    else if (!is_known_keyword_of_obj(keyword))
        findings_.note("OBJ has no statement " + in_quotes(keyword) +
                           " (its own are in small letters), so the line was skipped",
                       line_.number);
    return {};
}

// Behind the place may stand a weight, or a colour of three numbers from 0 to 1.
void ObjStatements::keep_vertex(const std::vector<std::string_view>& words) {
    positions_.push_back(checked_position(words, where()));
    if (words.size() < 7)
        return;
    colors_.resize(positions_.size(), glm::vec3(1.0f));
    colors_.back() = checked_color(words);
}

// A group has a name of its own where the file names no objects.
void ObjStatements::keep_object() {
    const bool is_group = line_.text[line_.text.find_first_not_of(spaces)] == 'g';
    if (is_group && has_objects_)
        return;
    has_objects_ = has_objects_ || !is_group;
    const std::string name(after_first_word(line_.text));
    const auto [entry, is_new] =
        index_of_object_.try_emplace(name, static_cast<int>(objects_.size()));
    if (is_new)
        objects_.push_back(name);
    object_ = entry->second;
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

namespace {

// Of the usual form, one a line.
std::size_t count_faces(std::string_view text) {
    std::size_t count = text.starts_with("f ") ? 1 : 0;
    for (std::size_t i = text.find("\nf "); i != std::string_view::npos;
         i = text.find("\nf ", i + 1))
        ++count;
    return count;
}

} // namespace

ObjReading::ObjReading(std::string_view text, const std::filesystem::path& path)
    : statements_(text, path) {
    file_.path = path;
    // An array that grows needs room for three of itself.
    const std::size_t faces = count_faces(text);
    file_.faces.reserve(faces);
    file_.corners.reserve(3 * faces);
}

void ObjReading::take_texture_coordinate(float x, float y) {
    file_.texture_coordinates.emplace_back(checked(x), checked(y));
}

// A float's square may be no float, so the length is taken in double.
void ObjReading::take_normal(float x, float y, float z) {
    const glm::dvec3 normal(x, y, z);
    const double length = glm::length(normal);
    if (length > 0.0 && std::isfinite(length)) {
        file_.normals.emplace_back(normal / length);
        return;
    }
    file_.normals.emplace_back(0.0f);
    statements_.findings().note(
        "A normal is zero or not finite; corners that name it get one that is made",
        statements_.line());
}

void ObjReading::take_material(const std::string& name) {
    const auto next = static_cast<int>(file_.material_names.size());
    const auto [entry, is_new] = index_of_material_.try_emplace(name, next);
    if (is_new)
        file_.material_names.push_back(name);
    material_name_ = entry->second;
}

void ObjReading::begin_face() {
    ObjFace face;
    face.line = statements_.line();
    face.first_corner = file_.corners.size();
    face.material_name = material_name_;
    face.smoothing_group = statements_.smoothing_group();
    face.number = statements_.face_number();
    face.object = statements_.object();
    file_.faces.push_back(face);
}

void ObjReading::take_corner(int position, int texture_coordinate, int normal) {
    const int texture_index =
        to_index(texture_coordinate, file_.texture_coordinates.size(), "texture coordinate");
    file_.corners.push_back({to_index(position, statements_.vertex_count(), "vertex"),
                             texture_index, to_index(normal, file_.normals.size(), "normal")});
    ++file_.faces.back().corner_count;
}

ObjFile ObjReading::finish(Origin origin) {
    drop_lacking_normals();
    for (const ObjFace& face : file_.faces)
        check_indices(face);
    place_positions(origin);
    file_.objects = std::move(statements_.objects());
    file_.libraries = statements_.libraries();
    file_.findings = statements_.findings();
    return std::move(file_);
}

// Vertices that no face names may lie anywhere.
void ObjReading::place_positions(Origin origin) {
    const std::vector<glm::dvec3>& positions = statements_.positions();
    if (origin == Origin::near_model) {
        DoubleBox box;
        for (const ObjCorner& corner : file_.corners)
            extend(box, positions[static_cast<std::size_t>(corner.position)]);
        file_.origin = offset_of(box);
    }
    file_.positions.reserve(positions.size());
    for (const glm::dvec3& position : positions)
        file_.positions.emplace_back(position - file_.origin);
    file_.colors = std::move(statements_.colors());
    if (!file_.colors.empty())
        file_.colors.resize(positions.size(), glm::vec3(1.0f));
}

// Some exports write 1//1 for every corner and no normal at all: a surface can do without.
void ObjReading::drop_lacking_normals() {
    if (!file_.normals.empty())
        return;
    for (const ObjFace& face : file_.faces) {
        bool names_normals = false;
        for (int i = 0; i < face.corner_count; ++i) {
            int& normal = file_.corners[face.first_corner + static_cast<std::size_t>(i)].normal;
            names_normals = names_normals || normal != not_given;
            normal = not_given;
        }
        if (names_normals)
            statements_.findings().note("A face names normals, but the file has none, so they are "
                                        "left out",
                                        face.line);
    }
}

float ObjReading::checked(float coordinate) const {
    if (std::abs(coordinate) <= static_cast<float>(greatest_coordinate))
        return coordinate;
    throw InputError(statements_.where().text() +
                     "a coordinate is not a number between -1.8e18 and 1.8e18. Check the export.");
}

int ObjReading::to_index(int number, std::size_t count, const char* what) const {
    if (number >= 0)
        return number - 1;
    const std::int64_t index = static_cast<std::int64_t>(count) + number;
    if (index >= 0)
        return static_cast<int>(index);
    throw InputError(statements_.where().text() + "face names " + what + " " +
                     std::to_string(number) + ", but only " + std::to_string(count) +
                     " stand above it. Check the export.");
}

void ObjReading::check_indices(const ObjFace& face) const {
    for (int i = 0; i < face.corner_count; ++i) {
        const ObjCorner& corner = file_.corners[face.first_corner + static_cast<std::size_t>(i)];
        if (corner.position == not_given)
            throw InputError(place(file_.path, face.line) +
                             "face has a corner without a vertex. Check the export.");
        check_index(corner.position, statements_.vertex_count(), "vertex", face);
        check_index(corner.texture_coordinate, file_.texture_coordinates.size(),
                    "texture coordinate", face);
        check_index(corner.normal, file_.normals.size(), "normal", face);
    }
}

void ObjReading::check_index(int index, std::size_t count, const char* what,
                             const ObjFace& face) const {
    if (index < static_cast<std::int64_t>(count))
        return;
    throw InputError(place(file_.path, face.line) + "face names " + what + " " +
                     std::to_string(index + std::int64_t{1}) + ", but the file has " +
                     std::to_string(count) + ". Check the export.");
}

} // namespace raysteps
