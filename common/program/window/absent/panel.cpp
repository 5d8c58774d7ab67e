// Without Dear ImGui there is no panel: the keys do the same, and are printed once.
#include "program/window/panel.h"

#include <iostream>

namespace raysteps {

struct Panel::Library {
    bool printed = false;
};

Panel::Panel(double) : library_(std::make_unique<Library>()) {}

Panel::~Panel() = default;

PanelWishes Panel::draw(const PanelContent& content, std::span<const PanelEvent>, const glm::dvec2&,
                        const glm::ivec2&) {
    if (library_->printed) {
        return {};
    }
    library_->printed = true;
    std::cout << "keys      (a panel has them where libimgui-dev is installed when Raysteps is "
                 "built)\n";
    for (const LiveChoice& choice : content.choices) {
        std::cout << "          " << choice.key << ": next " << choice.name << "\n";
    }
    if (content.reads_shaders) {
        std::cout << "          F5: read the shaders again\n";
    }
    for (const ControlLine& line : control_lines()) {
        std::cout << "          " << line.input << ": " << line.effect << "\n";
    }
    std::cout << std::flush;
    return {};
}

} // namespace raysteps
