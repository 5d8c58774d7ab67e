#pragma once

#include "gpu/gl.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raysteps {

// What a texel holds.
enum class TexelFormat {
    rgba32f,
    rgba32ui, // for bits that must not change: a shader may flush small floats to zero, never
              // integers
};

// Where the texels of a texture lie.
enum class TexelLayout {
    flat,      // in two dimensions: a sampler2D
    one_layer, // in an array of one layer: a sampler2DArray
    quads,     // texel (x, y) at (x / 2, y / 2) of layer x % 2 + 2 * (y % 2), in an array of four
               // layers: where a pass draws 2 x 2 texels at once. (core/hit_texels.glsl reads both)
};

// A texture without mipmaps that is read by texelFetch and drawn into.
// Owns the OpenGL object.
class Texture {
public:
    // Throws MachineError where the size is over the machine's limit, or memory is short.
    Texture(TexelFormat format, int width, int height, TexelLayout layout = TexelLayout::flat);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    GLuint id() const { return id_; }
    int width() const { return width_; }
    int height() const { return height_; }
    TexelFormat format() const { return format_; }
    TexelLayout layout() const { return layout_; }
    GLenum target() const; // of OpenGL: a kind of texture

    // As OpenGL sees it.
    int layers() const;
    int layer_width() const;
    int layer_height() const;

private:
    GLuint id_ = 0;
    TexelFormat format_;
    TexelLayout layout_;
    int width_;
    int height_;
};

// Texels row by row, the bottom row first, as OpenGL has them; width * height of them.
void write_texels(const Texture& texture, std::span<const glm::vec4> texels);
void write_texels(const Texture& texture, std::span<const glm::uvec4> texels);
std::vector<glm::vec4> read_floats(const Texture& texture);
std::vector<glm::uvec4> read_integers(const Texture& texture);

// A one-dimensional array that is read by texelFetch: four floats, four integers or one integer a
// texel.
// Owns the OpenGL objects.
class BufferTexture {
public:
    // Throws MachineError where the array is over the machine's limit, or memory is short.
    explicit BufferTexture(std::span<const glm::vec4> texels);
    explicit BufferTexture(std::span<const glm::ivec4> texels);
    explicit BufferTexture(std::span<const std::int32_t> texels);
    // Takes the array part by part: of a large one there is never a copy in memory beside it.
    explicit BufferTexture(std::vector<glm::vec4>&& texels);
    explicit BufferTexture(std::vector<glm::ivec4>&& texels);
    explicit BufferTexture(std::vector<std::int32_t>&& texels);
    // Of vectors with a zero behind each.
    explicit BufferTexture(std::span<const glm::vec3> vectors);
    ~BufferTexture();
    BufferTexture(BufferTexture&& other) noexcept;
    BufferTexture& operator=(BufferTexture&& other) noexcept;
    BufferTexture(const BufferTexture&) = delete;
    BufferTexture& operator=(const BufferTexture&) = delete;

    GLuint id() const { return id_; }

private:
    // Without bytes, room for them.
    BufferTexture(const void* bytes, std::size_t size, std::size_t texels, GLenum format);

    GLuint buffer_ = 0;
    GLuint id_ = 0;
};

} // namespace raysteps
