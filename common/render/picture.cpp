#include "render/picture.h"

namespace raysteps {

Image read_image(const Texture& texture) {
    const std::vector<glm::vec4> texels = read_floats(texture);
    Image image(texture.width(), texture.height());
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const auto from_bottom = static_cast<std::size_t>(image.height - 1 - row);
            image.at(column, row) =
                glm::vec3(texels[from_bottom * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(column)]);
        }
    }
    return image;
}

} // namespace raysteps
