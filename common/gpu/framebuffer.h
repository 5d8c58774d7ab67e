#pragma once

#include "gpu/gl.h"

namespace raysteps {

// A framebuffer object, current from its making to its end. Its maker attaches
// the targets.
class Framebuffer {
public:
    Framebuffer() {
        glGenFramebuffers(1, &id_);
        glBindFramebuffer(GL_FRAMEBUFFER, id_);
        glGenVertexArrays(1, &vertices_);
        glBindVertexArray(vertices_);
    }
    ~Framebuffer() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &id_);
        glDeleteVertexArrays(1, &vertices_);
    }
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

private:
    GLuint id_ = 0;
    GLuint vertices_ = 0; // core OpenGL draws nothing without one, even where no vertex has data
};

} // namespace raysteps
