#include "gpu/draw.h"

#include "basics/error.h"
#include "gpu/framebuffer.h"
#include "gpu/gl.h"

#include <cassert>

namespace raysteps {

namespace {

void attach(const Texture& texture, std::size_t place) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(place),
                           GL_TEXTURE_2D, texture.id(), 0);
}

void check_complete() {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw MachineError("This machine's OpenGL cannot draw into float and integer textures. "
                           "Update the driver, or try --context osmesa.");
    }
}

} // namespace

void cover(Shape shape, int width, int height) {
    glViewport(0, 0, width, height);
    if (shape == Shape::rectangle) {
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    } else {
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void draw(const Program& program, const Targets& targets) {
    assert(!targets.textures.empty());
    const Framebuffer framebuffer;
    std::vector<GLenum> buffers;
    for (std::size_t i = 0; i < targets.textures.size(); ++i) {
        attach(targets.textures[i], i);
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    }
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    if (targets.live) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                  targets.live->id());
    }
    check_complete();
    if (targets.live) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, 1, 1);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }
    if (targets.blend == Blend::add) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    program.use();
    const Texture& first = targets.textures.front();
    cover(targets.shape, first.width(), first.height());
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    check_gl("running a pass");
}

void clear(const Texture& texture) {
    const Framebuffer framebuffer;
    attach(texture, 0);
    check_complete();
    const GLfloat zeros[4] = {};
    const GLuint integer_zeros[4] = {};
    if (texture.format() == TexelFormat::rgba32ui) {
        glClearBufferuiv(GL_COLOR, 0, integer_zeros);
    } else {
        glClearBufferfv(GL_COLOR, 0, zeros);
    }
    check_gl("clearing a texture");
}

void add_points(const Program& program, const Texture& texture, int count) {
    const Framebuffer framebuffer;
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    const GLenum buffer = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &buffer);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    program.use();
    glViewport(0, 0, texture.width(), texture.height());
    glDrawArrays(GL_POINTS, 0, count);
    glDisable(GL_BLEND);
    check_gl("adding points");
}

} // namespace raysteps
