#include "gpu/live_mask.h"

#include "gpu/draw.h"
#include "gpu/framebuffer.h"
#include "gpu/gl.h"

#include <string>
#include <utility>

namespace raysteps {

namespace {

// Current while a mask is drawn to without any colour.
class MaskFramebuffer {
public:
    explicit MaskFramebuffer(const LiveMask& mask) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                  mask.id());
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, 1, 1);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }
    ~MaskFramebuffer() { glDisable(GL_STENCIL_TEST); }
    MaskFramebuffer(const MaskFramebuffer&) = delete;
    MaskFramebuffer& operator=(const MaskFramebuffer&) = delete;

private:
    Framebuffer framebuffer_;
};

} // namespace

LiveMask::LiveMask(int width, int height) : width_(width), height_(height) {
    clear_gl_errors();
    glGenRenderbuffers(1, &id_);
    glBindRenderbuffer(GL_RENDERBUFFER, id_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
    try {
        check_gl("making a mask of " + std::to_string(width) + " x " + std::to_string(height));
    } catch (...) {
        glDeleteRenderbuffers(1, &id_);
        throw;
    }
    const MaskFramebuffer framebuffer(*this);
    const GLint live = 1;
    glClearBufferiv(GL_STENCIL, 0, &live);
}

LiveMask::~LiveMask() {
    if (id_ != 0) {
        glDeleteRenderbuffers(1, &id_);
    }
}

LiveMask::LiveMask(LiveMask&& other) noexcept
    : id_(std::exchange(other.id_, 0)), width_(other.width_), height_(other.height_) {}

LiveMask& LiveMask::operator=(LiveMask&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    return *this;
}

void retire(LiveMask& mask, const Program& program) {
    const MaskFramebuffer framebuffer(mask);
    glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
    program.use();
    cover(Shape::triangle, mask.width(), mask.height());
    check_gl("retiring rays");
}

long count_live(const LiveMask& mask, const Program& program) {
    const MaskFramebuffer framebuffer(mask);
    program.use();
    const long count = count_drawn([&] { cover(Shape::triangle, mask.width(), mask.height()); });
    check_gl("counting rays");
    return count;
}

} // namespace raysteps
