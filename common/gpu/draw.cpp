#include "gpu/draw.h"

#include "basics/error.h"
#include "gpu/framebuffer.h"
#include "gpu/gl.h"

#include <cassert>

namespace raysteps {

namespace {

// Attaches textures one behind the other, each layer as a target of its own.
class Attachments {
public:
    void add(const Texture& texture) {
        for (int layer = 0; layer < texture.layers(); ++layer) {
            const GLenum place = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers_.size());
            if (texture.layout() == TexelLayout::flat) {
                glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, texture.id(), 0);
            } else {
                glFramebufferTextureLayer(GL_FRAMEBUFFER, place, texture.id(), 0, layer);
            }
            buffers_.push_back(place);
        }
        glDrawBuffers(count(), buffers_.data());
    }

    GLsizei count() const { return static_cast<GLsizei>(buffers_.size()); }

private:
    std::vector<GLenum> buffers_;
};

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
    Attachments attachments;
    for (const Texture& texture : targets.textures) {
        attachments.add(texture);
    }
    if (targets.live) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                  targets.live->id());
    }
    check_complete();
    if (targets.clear_to) {
        for (GLint i = 0; i < attachments.count(); ++i) {
            glClearBufferuiv(GL_COLOR, i, &targets.clear_to->x);
        }
    }
    if (targets.live) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, 1, 1);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glStencilMask(0); // else a pass that discards is run before the test
    }
    if (targets.blend == Blend::add) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    program.use();
    const Texture& first = targets.textures.front();
    cover(targets.shape, first.layer_width(), first.layer_height());
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glStencilMask(~0U);
    check_gl("running a pass");
}

long count_drawn(const std::function<void()>& drawing) {
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    drawing();
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint count = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    glDeleteQueries(1, &query);
    return static_cast<long>(count);
}

long draw_and_count(const Program& program, const Targets& targets) {
    return count_drawn([&] { draw(program, targets); });
}

void clear(const Texture& texture) {
    if (texture.format() == TexelFormat::rgba32ui) {
        clear(texture, glm::uvec4(0u));
        return;
    }
    const Framebuffer framebuffer;
    Attachments attachments;
    attachments.add(texture);
    check_complete();
    const GLfloat zeros[4] = {};
    glClearBufferfv(GL_COLOR, 0, zeros);
    check_gl("clearing a texture");
}

void clear(const Texture& texture, const glm::uvec4& value) {
    const Framebuffer framebuffer;
    Attachments attachments;
    attachments.add(texture);
    check_complete();
    for (GLint i = 0; i < attachments.count(); ++i) {
        glClearBufferuiv(GL_COLOR, i, &value.x);
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
