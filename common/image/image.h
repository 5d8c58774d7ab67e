#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace raysteps {

// A picture in linear RGB. Row 0 is the top one.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels; // width * height, row by row

    Image() = default;
    Image(int columns, int rows)
        : width(columns), height(rows),
          pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    glm::vec3& at(int column, int row) { return pixels[index(column, row)]; }
    const glm::vec3& at(int column, int row) const { return pixels[index(column, row)]; }

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

} // namespace raysteps
