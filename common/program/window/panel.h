#pragma once

#include "program/show.h"
#include "program/window/controls.h"

#include <glm/vec2.hpp>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// What a panel says.
struct PanelContent {
    const std::vector<LiveChoice>& choices;
    bool reads_shaders = false;
    std::span<const float>
        milliseconds; // of the last pictures; of coarse ones, as if they were full
    std::vector<std::string> notes{};
    std::string problem{}; // with the last choice, or with the shaders
    std::string command{}; // for the pixel that was clicked last
};

// What a person asks for by it.
struct PanelWishes {
    struct Word {
        std::size_t choice = 0;
        std::size_t word = 0;
    };
    std::vector<Word> words{};
    std::vector<char> letters{}; // of control_lines
    bool read_shaders = false;
};

// The panel over a window's picture: choices, keys and what there is to say. Owns OpenGL objects.
class Panel {
public:
    // Text is so many times its usual size. Throws MachineError where OpenGL cannot be drawn with.
    explicit Panel(double scale);
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    // Lets it hear what the mouse did, and draws it over a window of that size, which has so many
    // of the screen's pixels.
    PanelWishes draw(const PanelContent& content, std::span<const PanelEvent> events,
                     const glm::dvec2& window_size, const glm::ivec2& pixels);

    // Where the mouse is the panel's: everywhere while a list is open.
    const Covered& covered() const { return covered_; }

private:
    struct Library;
    std::unique_ptr<Library> library_;
    Covered covered_;
};

} // namespace raysteps
