// OSMesa: Mesa's software renderer without any window system. It left Mesa in version 25.1.
#include "basics/error.h"
#include "gpu/context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>

namespace raysteps {

namespace {

// Loaded where a context is made and not before: with its compiler it takes 0.09 s of processor
// time, which a program that draws nothing need not spend.
struct Library {
    decltype(&OSMesaCreateContextAttribs) create;
    decltype(&OSMesaMakeCurrent) make_current;
    decltype(&OSMesaGetProcAddress) find;
    decltype(&OSMesaDestroyContext) destroy;
};

template <class Function>
void take(void* file, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(file, name));
    if (!function) {
        throw MachineError(std::string("osmesa: " RAYSTEPS_OSMESA " has no ") + name +
                           ". Update Mesa, or try --context egl.");
    }
}

const Library& library() {
    static const Library loaded = [] {
        void* const file = dlopen(RAYSTEPS_OSMESA, RTLD_LAZY | RTLD_LOCAL);
        if (!file) {
            throw MachineError("osmesa: " RAYSTEPS_OSMESA " cannot be loaded. Install the package "
                               "libosmesa6, or try --context egl.");
        }
        Library functions{};
        take(file, "OSMesaCreateContextAttribs", functions.create);
        take(file, "OSMesaMakeCurrent", functions.make_current);
        take(file, "OSMesaGetProcAddress", functions.find);
        take(file, "OSMesaDestroyContext", functions.destroy);
        return functions;
    }();
    return loaded;
}

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
        context_ = library().create(attributes.data(), nullptr);
        if (!context_) {
            throw MachineError("osmesa: Mesa cannot make an OpenGL 4.1 core context. Update Mesa, "
                               "or try --context egl.");
        }
        if (!library().make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, side, side)) {
            library().destroy(context_);
            throw MachineError("osmesa: the context cannot be made current. Try --context egl.");
        }
        try {
            load_gl(library().find, "osmesa");
        } catch (...) {
            library().destroy(context_);
            throw;
        }
    }

    ~OsmesaContext() override { library().destroy(context_); }
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
