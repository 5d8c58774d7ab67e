#include "gpu/texture.h"

#include "basics/error.h"
#include "gpu/gl.h"
#include "gpu/limits.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace raysteps {

namespace {

struct FormatNames {
    GLint internal;
    GLenum layout;
    GLenum type;
};

FormatNames names_of(TexelFormat format) {
    if (format == TexelFormat::rgba32ui) {
        return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    }
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
}

std::string size_text(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

void write_bytes(const Texture& texture, const void* texels) {
    assert(texture.layout() != TexelLayout::quads);
    const FormatNames names = names_of(texture.format());
    glBindTexture(texture.target(), texture.id());
    if (texture.layout() == TexelLayout::flat) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.width(), texture.height(), names.layout,
                        names.type, texels);
    } else {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, texture.width(), texture.height(), 1,
                        names.layout, names.type, texels);
    }
    check_gl("writing a texture of " + size_text(texture.width(), texture.height()));
}

// All layers, one behind the other.
template <class Texel>
std::vector<Texel> read_layers(const Texture& texture) {
    const FormatNames names = names_of(texture.format());
    std::vector<Texel> texels(static_cast<std::size_t>(texture.layers()) *
                              static_cast<std::size_t>(texture.layer_width()) *
                              static_cast<std::size_t>(texture.layer_height()));
    glBindTexture(texture.target(), texture.id());
    glGetTexImage(texture.target(), 0, names.layout, names.type, texels.data());
    check_gl("reading a texture of " + size_text(texture.width(), texture.height()));
    return texels;
}

template <class Texel>
std::vector<Texel> read_texels(const Texture& texture) {
    std::vector<Texel> layers = read_layers<Texel>(texture);
    if (texture.layout() != TexelLayout::quads) {
        return layers;
    }
    std::vector<Texel> texels;
    texels.reserve(layers.size());
    for (int y = 0; y < texture.height(); ++y) {
        for (int x = 0; x < texture.width(); ++x) {
            const int layer = x % 2 + 2 * (y % 2);
            const int row = layer * texture.layer_height() + y / 2;
            texels.push_back(layers[static_cast<std::size_t>(row) *
                                        static_cast<std::size_t>(texture.layer_width()) +
                                    static_cast<std::size_t>(x / 2)]);
        }
    }
    return texels;
}

[[maybe_unused]] std::size_t texel_count(const Texture& texture) {
    return static_cast<std::size_t>(texture.width()) * static_cast<std::size_t>(texture.height());
}

} // namespace

Texture::Texture(TexelFormat format, int width, int height, TexelLayout layout)
    : format_(format), layout_(layout), width_(width), height_(height) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width < 1 || height < 1 || width > limit || height > limit) {
        throw MachineError("A texture of " + size_text(width, height) +
                           " is asked for, but this machine's OpenGL has 1 x 1 to " +
                           size_text(limit, limit) + ". Take another --size.");
    }
    const FormatNames names = names_of(format);
    clear_gl_errors();
    glGenTextures(1, &id_);
    glBindTexture(target(), id_);
    if (layout == TexelLayout::flat) {
        glTexImage2D(GL_TEXTURE_2D, 0, names.internal, width, height, 0, names.layout, names.type,
                     nullptr);
    } else {
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, names.internal, layer_width(), layer_height(),
                     layers(), 0, names.layout, names.type, nullptr);
    }
    glTexParameteri(target(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target(), GL_TEXTURE_MAX_LEVEL, 0);
    try {
        check_gl("making a texture of " + size_text(width, height));
    } catch (...) {
        glDeleteTextures(1, &id_);
        throw;
    }
}

Texture::~Texture() {
    if (id_ != 0) {
        glDeleteTextures(1, &id_);
    }
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)), format_(other.format_), layout_(other.layout_),
      width_(other.width_), height_(other.height_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(format_, other.format_);
    std::swap(layout_, other.layout_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    return *this;
}

GLenum Texture::target() const {
    return layout_ == TexelLayout::flat ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY;
}

int Texture::layers() const {
    return layout_ == TexelLayout::quads ? 4 : 1;
}

int Texture::layer_width() const {
    return layout_ == TexelLayout::quads ? (width_ + 1) / 2 : width_;
}

int Texture::layer_height() const {
    return layout_ == TexelLayout::quads ? (height_ + 1) / 2 : height_;
}

void write_texels(const Texture& texture, std::span<const glm::vec4> texels) {
    assert(texture.format() == TexelFormat::rgba32f && texels.size() == texel_count(texture));
    write_bytes(texture, texels.data());
}

void write_texels(const Texture& texture, std::span<const glm::uvec4> texels) {
    assert(texture.format() == TexelFormat::rgba32ui && texels.size() == texel_count(texture));
    write_bytes(texture, texels.data());
}

std::vector<glm::vec4> read_floats(const Texture& texture) {
    assert(texture.format() == TexelFormat::rgba32f);
    return read_texels<glm::vec4>(texture);
}

std::vector<glm::uvec4> read_integers(const Texture& texture) {
    assert(texture.format() == TexelFormat::rgba32ui);
    return read_texels<glm::uvec4>(texture);
}

BufferTexture::BufferTexture(std::span<const glm::vec4> texels)
    : BufferTexture(texels.data(), texels.size_bytes(), texels.size(), GL_RGBA32F) {}

BufferTexture::BufferTexture(std::span<const glm::ivec4> texels)
    : BufferTexture(texels.data(), texels.size_bytes(), texels.size(), GL_RGBA32I) {}

BufferTexture::BufferTexture(std::span<const std::int32_t> texels)
    : BufferTexture(texels.data(), texels.size_bytes(), texels.size(), GL_R32I) {}

namespace {

// Into the bound buffer. The pages behind an array that will not be read again go back to the
// system as soon as their part is there.
template <class Texel>
void move_into_buffer(std::vector<Texel> texels) {
    constexpr std::size_t part = std::size_t{1} << 24; // in bytes, and a multiple of any page
    auto* const bytes = reinterpret_cast<char*>(texels.data());
    const std::size_t size = texels.size() * sizeof(Texel);
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    for (std::size_t first = 0; first < size; first += part) {
        const std::size_t length = std::min(part, size - first);
        glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first),
                        static_cast<GLsizeiptr>(length), bytes + first);
        const auto address = reinterpret_cast<std::uintptr_t>(bytes + first);
        const std::size_t ahead = (page - address % page) % page; // to the first whole page
        if (length > ahead + page) {
            madvise(bytes + first + ahead, (length - ahead) / page * page, MADV_DONTNEED);
        }
    }
}

} // namespace

BufferTexture::BufferTexture(std::vector<glm::vec4>&& texels)
    : BufferTexture(nullptr, texels.size() * sizeof(glm::vec4), texels.size(), GL_RGBA32F) {
    move_into_buffer(std::move(texels));
}

BufferTexture::BufferTexture(std::vector<glm::ivec4>&& texels)
    : BufferTexture(nullptr, texels.size() * sizeof(glm::ivec4), texels.size(), GL_RGBA32I) {
    move_into_buffer(std::move(texels));
}

BufferTexture::BufferTexture(std::vector<std::int32_t>&& texels)
    : BufferTexture(nullptr, texels.size() * sizeof(std::int32_t), texels.size(), GL_R32I) {
    move_into_buffer(std::move(texels));
}

// In parts, so that there are never two of millions of texels.
BufferTexture::BufferTexture(std::span<const glm::vec3> vectors)
    : BufferTexture(nullptr, vectors.size() * sizeof(glm::vec4), vectors.size(), GL_RGBA32F) {
    constexpr std::size_t part = 1 << 16;
    std::vector<glm::vec4> texels;
    for (std::size_t first = 0; first < vectors.size(); first += part) {
        texels.clear();
        for (const glm::vec3& vector :
             vectors.subspan(first, std::min(part, vectors.size() - first))) {
            texels.emplace_back(vector, 0.0f);
        }
        glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * sizeof(glm::vec4)),
                        static_cast<GLsizeiptr>(texels.size() * sizeof(glm::vec4)), texels.data());
    }
    check_gl("filling a buffer texture of " + std::to_string(vectors.size()) + " texels");
}

BufferTexture::BufferTexture(const void* bytes, std::size_t size, std::size_t texels,
                             GLenum format) {
    const int limit = most_buffer_texels();
    if (texels > static_cast<std::size_t>(limit)) {
        throw MachineError("A buffer texture of " + std::to_string(texels) +
                           " texels is asked for, but this machine's OpenGL has at most " +
                           std::to_string(limit) + ". Take a scene with fewer triangles.");
    }
    clear_gl_errors();
    glGenBuffers(1, &buffer_);
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
    // An empty buffer cannot be bound to a texture: an empty array keeps room for one texel.
    constexpr GLsizeiptr one_texel = 16;
    glBufferData(GL_TEXTURE_BUFFER, texels == 0 ? one_texel : static_cast<GLsizeiptr>(size),
                 texels == 0 ? nullptr : bytes, GL_STATIC_DRAW);
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_BUFFER, id_);
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer_);
    try {
        check_gl("making a buffer texture of " + std::to_string(texels) + " texels");
    } catch (...) {
        glDeleteTextures(1, &id_);
        glDeleteBuffers(1, &buffer_);
        throw;
    }
}

BufferTexture::~BufferTexture() {
    if (id_ != 0) {
        glDeleteTextures(1, &id_);
        glDeleteBuffers(1, &buffer_);
    }
}

BufferTexture::BufferTexture(BufferTexture&& other) noexcept
    : buffer_(std::exchange(other.buffer_, 0)), id_(std::exchange(other.id_, 0)) {}

BufferTexture& BufferTexture::operator=(BufferTexture&& other) noexcept {
    std::swap(buffer_, other.buffer_);
    std::swap(id_, other.id_);
    return *this;
}

} // namespace raysteps
