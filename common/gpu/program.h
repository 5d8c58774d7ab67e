#pragma once

#include "gpu/gl.h"
#include "gpu/shaders.h"
#include "gpu/texture.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace raysteps {

// The vertex pass that goes with a fragment pass: its namesake where there is one, else the one
// that covers the picture with one triangle.
std::string vertex_pass_of(const std::string& fragment_pass);

// A fragment pass, its vertex pass and their parts, compiled and linked. Owns the OpenGL object.
class Program {
public:
    // Throws MachineError with the compiler's message, which names file and line. The slot <real>
    // is single precision where parts do not say otherwise.
    explicit Program(const std::string& fragment_pass, Parts parts = {});
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // Values of uniforms. A name that the parts at hand do not use is passed over, since a part may
    // ignore what its role offers.
    Program& set(const std::string& name, int value);
    Program& set(const std::string& name, float value);
    Program& set(const std::string& name, const glm::vec2& value);
    Program& set(const std::string& name, const glm::vec3& value);
    Program& set(const std::string& name, const glm::ivec3& value);
    Program& set(const std::string& name, const Texture& value);
    Program& set(const std::string& name, const BufferTexture& value);

    // Makes the program and its textures current. The textures must live until it has been drawn
    // with.
    void use() const;

private:
    // The index of a texture among the bindings is its texture unit.
    struct Binding {
        GLint location;
        GLenum target;
        GLuint texture;
    };

    void bind(const std::string& name, GLenum target, GLuint texture);

    GLuint id_ = 0;
    std::vector<Binding> bindings_;
};

} // namespace raysteps
