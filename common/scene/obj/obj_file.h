#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace raysteps {

// "bunny.obj:1204: ", the place that a sentence is about.
std::string place(const std::filesystem::path& path, std::int64_t line);

// The same, put into words where a sentence needs it only.
struct ObjPlace {
    const std::filesystem::path& path;
    std::int64_t line;

    std::string text() const { return place(path, line); }
};

// What findings in a file are counted by.
enum class FindingsCount { lines, faces };

// Collects what was corrected or dropped in a file: one sentence for each kind of finding with its
// count and first lines, however often it was found.
class ObjFindings {
public:
    // The sentence comes without its full stop.
    void note(const std::string& sentence, std::int64_t line);

    // The sentences about the file, in the order in which their kinds were first found.
    std::vector<std::string> sentences(const std::filesystem::path& path,
                                       FindingsCount counts = FindingsCount::lines) const;

private:
    struct Finding {
        std::string sentence;
        std::int64_t count = 0;
        std::vector<std::int64_t> first_lines;
    };

    std::vector<Finding> findings_;
    std::unordered_map<std::string, std::size_t> index_of_sentence_;
};

// From where positions are counted: as in the file, or, where that is too far off for floats, from
// a point near the model (offset_of in scene/scaling.h).
enum class Origin { of_file, near_model };

inline constexpr int not_given = -1;

// A corner of a face: indices into the lists of its file, counted from 0, or not_given.
struct ObjCorner {
    int position = not_given;
    int texture_coordinate = not_given;
    int normal = not_given;
};

// Owns the corners [first_corner, first_corner + corner_count). Smoothing group 0 is flat.
struct ObjFace {
    std::int64_t line = 0;
    std::size_t first_corner = 0;
    int corner_count = 0;
    int material_name = not_given;
    int smoothing_group = 0;
    int number = 0; // of the face in its file, from 1; those that were dropped count
    int object = 0; // of ObjFile::objects
};

// The name of a material file, and the line that asks for it.
struct ObjLibrary {
    std::string name;
    std::int64_t line = 0;
};

// What an OBJ file says, or one that is like it, before anything is made of it. Every coordinate is
// finite, and every index of a corner is in range. A normal is zero where the file gave none that
// has a direction.
struct ObjFile {
    std::filesystem::path path;
    glm::dvec3 origin{0.0}; // was taken from the positions
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colors; // of the positions, linear RGB; empty where none has one
    std::vector<glm::vec2> texture_coordinates;
    std::vector<glm::vec3> normals;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<std::string> material_names;
    std::vector<std::string> objects; // their names (o, else g)
    std::vector<int> primitives;      // of the objects, their NamedRun::primitive; or empty
    std::vector<ObjLibrary> libraries;
    ObjFindings findings;
    FindingsCount counts = FindingsCount::lines; // else `line` is the number of a face
};

// Coordinates above this are refused: the square of a distance between two such points,
// 3 * (2 * 1.8e18)^2 = 3.9e37, is still a float (at most 3.4e38).
inline constexpr double greatest_coordinate = 1.8e18;

// The number that the whole word spells, which may be infinite or NaN (`inf`, `nan`);
// nothing where the word spells no number. What a double cannot hold counts as infinite.
std::optional<double> to_number(std::string_view word);

// The whole number that the word spells; nothing where it spells none or one beyond 64 bits.
std::optional<std::int64_t> to_whole_number(std::string_view word);

struct TextLine {
    std::int64_t number = 0; // counted from 1; of joined lines, the first
    std::string_view text;   // valid until the next line is read
};

// Reads the lines of an OBJ or MTL text: LF, CRLF or CR end a line, a backslash before the end
// joins the next one, and a UTF-8 byte order mark at the start is left out. A comment joins
// nothing, because comments end in paths such as C:\models\.
class LineReader {
public:
    explicit LineReader(std::string_view text);
    std::optional<TextLine> next();

private:
    std::string_view take_line();

    std::string_view rest_;
    std::string joined_;
    std::int64_t lines_taken_ = 0;
};

// The words of a line, which are set apart by spaces and tabs.
std::vector<std::string_view> split_words(std::string_view text);

// The words without a comment: those before the first that begins with '#'.
std::vector<std::string_view> split_values(std::string_view text);

// What follows the first word, without the space around it: a name, which may hold spaces.
std::string_view after_first_word(std::string_view text);

// Reads an OBJ text statement by statement and lets through only what tinyobjloader reads rightly:
// left alone it takes `nan` and `V` for nothing, 4294967297 for 1 and a comment for a corner, all
// without a word. What it has no callback for, smoothing groups and material files, is kept here,
// and so are vertices, which it reads as floats, and the names of objects.
class ObjStatements {
public:
    ObjStatements(std::string_view text, const std::filesystem::path& path);

    // The next vn, vt, f or usemtl statement with a line end; empty after the last.
    // Throws InputError where a statement cannot be used.
    std::string next();

    // Of the statement that next gave last.
    std::int64_t line() const { return line_.number; }
    ObjPlace where() const { return {path_, line_.number}; }
    int smoothing_group() const { return smoothing_group_; }
    int face_number() const { return face_number_; }
    int object() const { return object_; }

    std::size_t vertex_count() const { return positions_.size(); }

    // What was kept, once all statements were given.
    std::vector<glm::dvec3>& positions() { return positions_; }
    std::vector<glm::vec3>& colors() { return colors_; }
    std::vector<std::string>& objects() { return objects_; }

    const std::vector<ObjLibrary>& libraries() const { return libraries_; }
    ObjFindings& findings() { return findings_; }

private:
    std::string checked(const std::vector<std::string_view>& words);
    void keep_vertex(const std::vector<std::string_view>& words);
    void keep_library();
    void keep_object();
    void keep_smoothing_group(const std::vector<std::string_view>& words);

    std::filesystem::path path_;
    LineReader lines_;
    TextLine line_;
    int smoothing_group_ = 0;
    int face_number_ = 0;
    int object_ = 0;
    bool has_objects_ = false; // by o; then groups (g) are parts of them
    std::vector<glm::dvec3> positions_;
    std::vector<glm::vec3> colors_;
    std::vector<std::string> objects_{""};
    std::unordered_map<std::string, int> index_of_object_{{"", 0}};
    std::vector<ObjLibrary> libraries_;
    ObjFindings findings_;
};

// Takes what a parser makes of the statements, checks it once more, since parsers have bugs, and
// puts it together to an ObjFile. Indices come as the file counts them: from 1, or back from the
// newest with negative numbers, and 0 where none is given. Throws InputError with file and line.
class ObjReading {
public:
    ObjReading(std::string_view text, const std::filesystem::path& path);

    // The text to be parsed, as ObjStatements gives it.
    std::string next_statement() { return statements_.next(); }

    void take_texture_coordinate(float x, float y);
    void take_normal(float x, float y, float z);
    void take_material(const std::string& name);
    void begin_face();
    void take_corner(int position, int texture_coordinate, int normal);

    // After the last statement. Only then is it known how many vertices the file has.
    ObjFile finish(Origin origin);

private:
    float checked(float coordinate) const;
    void place_positions(Origin origin);
    void drop_lacking_normals();
    int to_index(int number, std::size_t count, const char* what) const;
    void check_indices(const ObjFace& face) const;
    void check_index(int index, std::size_t count, const char* what, const ObjFace& face) const;

    ObjStatements statements_;
    ObjFile file_;
    std::unordered_map<std::string, int> index_of_material_;
    int material_name_ = not_given;
};

} // namespace raysteps
