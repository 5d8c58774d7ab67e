#include "scene/toml_transform.h"

#include "scene/obj_numbers.h"
#include "scene/toml_values.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace raysteps {

namespace {

constexpr TomlRange any_coordinate{-greatest_coordinate, greatest_coordinate};
constexpr TomlRange any_degrees{-360'000.0, 360'000.0};

glm::dmat3 scaling(const toml::node& node) {
    glm::dvec3 factors{1.0};
    if (node.is_number()) {
        factors = glm::dvec3(toml_number(node, "scale", any_coordinate));
    } else if (node.is_array()) {
        const std::vector<double> numbers = toml_numbers(node, "scale", 3, any_coordinate);
        factors = {numbers[0], numbers[1], numbers[2]};
    } else {
        throw toml_error(node.source(), "scale must be a number or an array of 3 numbers.");
    }
    glm::dmat3 matrix{1.0};
    for (int i = 0; i < 3; ++i) {
        matrix[i][i] = factors[i];
    }
    return matrix;
}

// By the formula of Rodrigues (1840): what points along the axis stays, what is across it turns.
glm::dmat3 rotation(const toml::node& node) {
    const toml::table& table = toml_table(node, "rotate");
    check_toml_keys(table, "rotate", {"axis", "degrees"});
    const toml::node* axis_node = table.get("axis");
    const toml::node* degrees_node = table.get("degrees");
    if (axis_node == nullptr || degrees_node == nullptr) {
        throw toml_error(node.source(),
                         "rotate needs both, as in { axis = [0, 1, 0], degrees = 90 }.");
    }
    const glm::dvec3 given(toml_vec3(*axis_node, "axis", any_coordinate));
    if (given == glm::dvec3(0.0)) {
        throw toml_error(axis_node->source(), "axis must not be [0, 0, 0].");
    }
    const glm::dvec3 axis = glm::normalize(given);
    const double angle = glm::radians(toml_number(*degrees_node, "degrees", any_degrees));
    glm::dmat3 matrix;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 unit{0.0};
        unit[i] = 1.0;
        const glm::dvec3 along = glm::dot(axis, unit) * axis;
        matrix[i] =
            along + std::cos(angle) * (unit - along) + std::sin(angle) * glm::cross(axis, unit);
    }
    return matrix;
}

glm::mat4 whole_matrix(const toml::node& node) {
    const std::vector<double> rows = toml_numbers(node, "matrix", 16, any_coordinate);
    glm::mat4 matrix;
    auto number = rows.begin();
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix[column][row] = static_cast<float>(*number++);
        }
    }
    const glm::vec4 last_row{matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]};
    if (last_row != glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)) {
        throw toml_error(node.source(), "the last row of matrix must be 0, 0, 0, 1.");
    }
    return matrix;
}

// Whether the columns span no volume. Their numbers were rounded to floats, by up to 2^-24 each, so
// columns that lie in one plane can seem to span a share of up to about 6 * 2^-24 < 1e-6 of the
// volume that they would span at right angles.
bool flattens(const glm::mat4& matrix) {
    glm::dmat3 directions;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 column(matrix[i]);
        if (column == glm::dvec3(0.0)) {
            return true;
        }
        directions[i] = glm::normalize(column);
    }
    return std::abs(glm::determinant(directions)) < 1e-6;
}

glm::mat4 composed_matrix(const toml::table& model) {
    glm::dmat3 linear{1.0};
    if (const toml::node* scale = model.get("scale")) {
        linear = scaling(*scale);
    }
    if (const toml::node* rotate = model.get("rotate")) {
        linear = rotation(*rotate) * linear;
    }
    glm::mat4 matrix = glm::mat4(glm::mat3(linear));
    if (const toml::node* translate = model.get("translate")) {
        matrix[3] = glm::vec4(toml_vec3(*translate, "translate", any_coordinate), 1.0f);
    }
    return matrix;
}

} // namespace

glm::mat4 toml_transform(const toml::table& model) {
    const toml::node* matrix_node = model.get("matrix");
    for (const char* key : {"translate", "rotate", "scale"}) {
        if (matrix_node != nullptr && model.contains(key)) {
            throw toml_error(model.get(key)->source(),
                             std::string(key) + " and matrix exclude each other. Keep one.");
        }
    }
    const glm::mat4 matrix =
        matrix_node != nullptr ? whole_matrix(*matrix_node) : composed_matrix(model);
    if (flattens(matrix)) {
        throw toml_error(model.source(), "this transform flattens the model: no scale may be 0, "
                                         "and no row of a matrix may depend on the others.");
    }
    return matrix;
}

} // namespace raysteps
