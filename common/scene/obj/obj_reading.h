#pragma once

#include "scene/obj_file.h"
#include "scene/obj_statements.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace raysteps {

// Takes what a parser makes of the statements, checks it once more, since parsers have faults, and
// puts it together to an ObjFile. Indices come as the file counts them: from 1, or back from the
// newest with negative numbers, and 0 where none is given. Throws InputError with file and line.
class ObjReading {
public:
    ObjReading(std::string_view text, const std::filesystem::path& path);

    // The text to be parsed, as ObjStatements gives it.
    std::string next_statement() { return statements_.next(); }

    void take_position(float x, float y, float z);
    void take_texture_coordinate(float x, float y);
    void take_normal(float x, float y, float z);
    void take_material(const std::string& name);
    void begin_face();
    void take_corner(int position, int texture_coordinate, int normal);

    // After the last statement. Only then is it known how many vertices the file has.
    ObjFile finish();

private:
    float checked(float coordinate) const;
    int to_index(int number, std::size_t count, const char* what) const;
    void check_indices(const ObjFace& face) const;
    void check_index(int index, std::size_t count, const char* what, const ObjFace& face) const;

    ObjStatements statements_;
    ObjFile file_;
    std::unordered_map<std::string, int> index_of_material_;
    int material_name_ = not_given;
};

} // namespace raysteps
