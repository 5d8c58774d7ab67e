#pragma once

#include <memory>
#include <optional>
#include <string>

struct GLFWwindow;

namespace raysteps {

// Where OpenGL runs.
enum class ContextKind {
    automatic, // a hardware GPU through EGL where there is one, else OSMesa
    osmesa,    // on the processor, without a display
    egl,       // without a display: a GPU, else Mesa on the processor
    window,    // a window of GLFW, which needs a display
};

// An OpenGL 4.1 core context that is current from its making to its end. One lives at a time.
class Context {
public:
    Context();
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

// Makes a context and loads OpenGL into it. Throws MachineError where there is none, or one that is
// too old.
std::unique_ptr<Context> make_context(ContextKind kind);

// What OpenGL says of itself.
struct OpenGl {
    std::string renderer; // `llvmpipe (LLVM 15.0.6, 256 bits)`
    std::string version;  // `4.5 (Core Profile) Mesa 22.3.6`
};

// Of the context that lives; nothing where none does.
std::optional<OpenGl> current_opengl();

// Both in one line. A context must be current.
std::string renderer_name();

// Whether that renderer runs on the processor, so that its work is processor time of this process.
bool runs_on_processor(const std::string& renderer);

// The providers, each a file in context/. They throw MachineError.
std::unique_ptr<Context> make_osmesa_context();

enum class EglDevices { hardware_only, any };
std::unique_ptr<Context> make_egl_context(EglDevices devices);

enum class Visibility { hidden, shown };

class WindowContext : public Context {
public:
    virtual GLFWwindow* window() const = 0;
};

std::unique_ptr<WindowContext> make_window_context(int width, int height, Visibility visibility);

// Loads OpenGL through a provider's lookup function; throws MachineError below version 4.1.
using GlFunction = void (*)();
using FindGlFunction = GlFunction (*)(const char* name);
void load_gl(FindGlFunction find, const std::string& provider);

} // namespace raysteps
