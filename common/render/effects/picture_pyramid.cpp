#include "effects/picture_pyramid.h"

#include <algorithm>

namespace raysteps {

namespace {

// The finer texels from first up to end that the texel covers along one axis; an odd last one
// belongs to its neighbour's texel, too.
struct Range {
    int first;
    int end;
};

Range covered(int texel, int finer_size, int size) {
    return {static_cast<int>(static_cast<long>(texel) * finer_size / size),
            static_cast<int>((static_cast<long>(texel + 1) * finer_size + size - 1) / size)};
}

Image halved(const Image& finer) {
    Image image(std::max(1, finer.width / 2), std::max(1, finer.height / 2));
    for (int row = 0; row < image.height; ++row) {
        const Range rows = covered(row, finer.height, image.height);
        for (int column = 0; column < image.width; ++column) {
            const Range columns = covered(column, finer.width, image.width);
            glm::dvec3 sum(0.0);
            for (int y = rows.first; y < rows.end; ++y) {
                for (int x = columns.first; x < columns.end; ++x) {
                    sum += glm::dvec3(finer.at(x, y));
                }
            }
            const int count = (rows.end - rows.first) * (columns.end - columns.first);
            image.at(column, row) = glm::vec3(sum / static_cast<double>(count));
        }
    }
    return image;
}

} // namespace

std::vector<Image> picture_pyramid(const Image& picture) {
    std::vector<Image> levels{picture};
    while (levels.back().width > 1 || levels.back().height > 1) {
        levels.push_back(halved(levels.back()));
    }
    return levels;
}

} // namespace raysteps
