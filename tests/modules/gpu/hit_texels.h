#pragma once

#include "gpu/texture.h"

#include <functional>
#include <vector>

// A texture of hits, of which only the triangles count: -1 is a miss. They decide which pixels the
// pass select_misses draws.
inline raysteps::Texture hit_texels(int width, int height,
                                    const std::function<int(int column, int row)>& triangle) {
    std::vector<glm::uvec4> texels;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            texels.emplace_back(0u, 0u, 0u, static_cast<unsigned>(triangle(column, row)));
        }
    }
    raysteps::Texture texture(raysteps::TexelFormat::rgba32ui, width, height,
                              raysteps::TexelLayout::one_layer);
    write_texels(texture, texels);
    return texture;
}
