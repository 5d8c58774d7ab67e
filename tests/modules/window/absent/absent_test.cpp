#include "basics/error.h"
#include "catch.h"
#include "program/show.h"

using namespace raysteps;

namespace {

class NoWindow final : public WindowContext {
public:
    GLFWwindow* window() const override { return nullptr; }
};

} // namespace

TEST_CASE("a program built without GLFW says what to install for a window", "[window]") {
    NoWindow context;
    const auto show = [&] { show_in_window(context, Camera{}, "name", RenderPicture()); };
    CHECK_THROWS_AS(show(), MachineError);
    CHECK_THROWS_WITH(show(), contains_text("libglfw3-dev"));
}
