// OSMesa: Mesa's software renderer without any window system. It left Mesa in version 25.1.
#include "basics/error.h"
#include "gpu/context.h"

#include <GL/osmesa.h>

#include <array>

namespace raysteps {

namespace {

class OsmesaContext final : public Context {
public:
    OsmesaContext() {
        const std::array<int, 11> attributes{OSMESA_FORMAT,
                                             OSMESA_RGBA,
                                             OSMESA_DEPTH_BITS,
                                             0,
                                             OSMESA_PROFILE,
                                             OSMESA_CORE_PROFILE,
                                             OSMESA_CONTEXT_MAJOR_VERSION,
                                             4,
                                             OSMESA_CONTEXT_MINOR_VERSION,
                                             1,
                                             0};
        context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
        if (!context_) {
            throw MachineError("osmesa: Mesa cannot make an OpenGL 4.1 core context. Update Mesa, "
                               "or try --context egl.");
        }
        if (!OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, side, side)) {
            OSMesaDestroyContext(context_);
            throw MachineError("osmesa: the context cannot be made current. Try --context egl.");
        }
        try {
            load_gl(OSMesaGetProcAddress, "osmesa");
        } catch (...) {
            OSMesaDestroyContext(context_);
            throw;
        }
    }

    ~OsmesaContext() override { OSMesaDestroyContext(context_); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

private:
    // The default framebuffer is never drawn to; OSMesa wants one all the same.
    static constexpr int side = 4;
    std::array<unsigned char, 4 * side * side> pixels_{};
    OSMesaContext context_ = nullptr;
};

} // namespace

std::unique_ptr<Context> make_osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

} // namespace raysteps
