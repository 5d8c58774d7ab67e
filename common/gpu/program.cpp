#include "gpu/program.h"

#include "basics/error.h"
#include "gpu/gl.h"

#include <utility>

namespace raysteps {

namespace {

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
    if (length > 0) {
        glGetShaderInfoLog(shader, length, &length, log.data());
        log.resize(length);
    }
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
    if (length > 0) {
        glGetProgramInfoLog(program, length, &length, log.data());
        log.resize(length);
    }
    return log;
}

GLuint compile(GLenum kind, const std::string& pass, const Parts& parts) {
    const ShaderText shader = read_shader(pass, parts);
    const GLuint id = glCreateShader(kind);
    const char* text = shader.text.c_str();
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    GLint compiled = GL_FALSE;
    glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        const std::string messages = name_files(shader_log(id), shader.files);
        glDeleteShader(id);
        throw MachineError("The shader " + pass +
                           " does not compile. Fix the line that is named:\n" + messages);
    }
    return id;
}

} // namespace

std::string vertex_pass_of(const std::string& fragment_pass) {
    const std::string namesake =
        std::filesystem::path(fragment_pass).replace_extension(".vert").generic_string();
    return std::filesystem::exists(shader_folder() / namesake) ? namesake : "pass/full_screen.vert";
}

Program::Program(const std::string& fragment_pass, Parts parts) {
    parts.try_emplace("real", "real/float.glsl");
    const std::string vertex_pass = vertex_pass_of(fragment_pass);
    const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_pass, parts);
    GLuint fragment = 0;
    try {
        fragment = compile(GL_FRAGMENT_SHADER, fragment_pass, parts);
    } catch (...) {
        glDeleteShader(vertex);
        throw;
    }
    id_ = glCreateProgram();
    glAttachShader(id_, vertex);
    glAttachShader(id_, fragment);
    glLinkProgram(id_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint linked = GL_FALSE;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (!linked) {
        const std::string messages = program_log(id_);
        glDeleteProgram(id_);
        throw MachineError("The shaders " + vertex_pass + " and " + fragment_pass +
                           " do not link. Fix what is named:\n" + messages);
    }
}

Program::~Program() {
    if (id_ != 0) {
        glDeleteProgram(id_);
    }
}

Program::Program(Program&& other) noexcept
    : id_(std::exchange(other.id_, 0)), bindings_(std::move(other.bindings_)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(bindings_, other.bindings_);
    return *this;
}

Program& Program::set(const std::string& name, int value) {
    glUseProgram(id_);
    glUniform1i(glGetUniformLocation(id_, name.c_str()), value);
    return *this;
}

Program& Program::set(const std::string& name, float value) {
    glUseProgram(id_);
    glUniform1f(glGetUniformLocation(id_, name.c_str()), value);
    return *this;
}

Program& Program::set(const std::string& name, const glm::vec2& value) {
    glUseProgram(id_);
    glUniform2f(glGetUniformLocation(id_, name.c_str()), value.x, value.y);
    return *this;
}

Program& Program::set(const std::string& name, const glm::vec3& value) {
    glUseProgram(id_);
    glUniform3f(glGetUniformLocation(id_, name.c_str()), value.x, value.y, value.z);
    return *this;
}

Program& Program::set(const std::string& name, const glm::ivec3& value) {
    glUseProgram(id_);
    glUniform3i(glGetUniformLocation(id_, name.c_str()), value.x, value.y, value.z);
    return *this;
}

Program& Program::set(const std::string& name, const Texture& value) {
    bind(name, value.target(), value.id());
    return *this;
}

Program& Program::set(const std::string& name, const BufferTexture& value) {
    bind(name, GL_TEXTURE_BUFFER, value.id());
    return *this;
}

void Program::use() const {
    glUseProgram(id_);
    for (std::size_t unit = 0; unit < bindings_.size(); ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(bindings_[unit].target, bindings_[unit].texture);
    }
    glActiveTexture(GL_TEXTURE0);
}

void Program::bind(const std::string& name, GLenum target, GLuint texture) {
    const GLint location = glGetUniformLocation(id_, name.c_str());
    if (location < 0) {
        return;
    }
    for (Binding& binding : bindings_) {
        if (binding.location == location) {
            binding.target = target;
            binding.texture = texture;
            return;
        }
    }
    glUseProgram(id_);
    glUniform1i(location, static_cast<GLint>(bindings_.size()));
    bindings_.push_back({location, target, texture});
}

} // namespace raysteps
