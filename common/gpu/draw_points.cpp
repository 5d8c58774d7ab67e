#include "gpu/draw_points.h"

#include "gpu/check_gl.h"
#include "gpu/framebuffer.h"

namespace raysteps {

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
