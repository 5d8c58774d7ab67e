#pragma once

#include "gpu/gl.h"
#include "gpu/program.h"

namespace raysteps {

// Which pixels still have a ray: a stencil buffer beside the textures of a picture. The test runs
// before the fragment program, so a dead pixel costs nothing. Owns the OpenGL object.
class LiveMask {
public:
    // All pixels live.
    LiveMask(int width, int height);
    ~LiveMask();
    LiveMask(LiveMask&& other) noexcept;
    LiveMask& operator=(LiveMask&& other) noexcept;
    LiveMask(const LiveMask&) = delete;
    LiveMask& operator=(const LiveMask&) = delete;

    GLuint id() const { return id_; }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    GLuint id_ = 0;
    int width_;
    int height_;
};

// Takes out of the mask the live pixels that the program draws; those it discards stay.
void retire(LiveMask& mask, const Program& program);

// How many live pixels the program draws (it discards the others): an occlusion query.
long count_live(const LiveMask& mask, const Program& program);

} // namespace raysteps
