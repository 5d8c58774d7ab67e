#pragma once

#include "shapes.h"
#include "visualizer/color_scale.h"
#include "visualizer/layout.h"
#include "visualizer/replay/recorded_path.h"

#include <glm/vec3.hpp>
#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <optional>
#include <string>
#include <vector>

namespace raysteps::view {

// Colours, in sRGB. Those that distinguish things are from Okabe and Ito, "Color Universal Design",
// 2008, a set for every kind of colour vision.
inline constexpr glm::vec3 paper{0.985f, 0.985f, 0.975f};
inline constexpr glm::vec3 panel{0.935f, 0.940f, 0.948f};
inline constexpr glm::vec3 ink{0.12f, 0.14f, 0.18f};
inline constexpr glm::vec3 faint_ink{0.42f, 0.45f, 0.50f};
inline constexpr glm::vec3 warning_ink{0.72f, 0.10f, 0.08f};
inline constexpr glm::vec3 rule_color{0.78f, 0.80f, 0.83f};

inline constexpr glm::vec3 model_color{0.58f, 0.63f, 0.70f};
inline constexpr glm::vec3 current_color{0.90f, 0.62f, 0.00f}; // orange
inline constexpr glm::vec3 culled_color{0.55f, 0.55f, 0.55f};
inline constexpr glm::vec3 tested_color{0.34f, 0.71f, 0.91f};   // sky blue
inline constexpr glm::vec3 hit_color{0.84f, 0.37f, 0.00f};      // vermillion
inline constexpr glm::vec3 selected_color{0.80f, 0.47f, 0.65f}; // reddish purple

inline glm::vec3 color_of(RayRole role) {
    switch (role) {
    case RayRole::shadow:
        return {0.25f, 0.25f, 0.25f};
    case RayRole::mirror:
        return {0.00f, 0.62f, 0.45f}; // bluish green
    case RayRole::refraction:
        return {0.64f, 0.31f, 0.50f}; // reddish purple, darker
    case RayRole::camera:
        break;
    }
    return {0.00f, 0.45f, 0.70f}; // blue
}

// The colour of a step's mark on the slider.
inline glm::vec3 color_of(const Step& step) {
    if (is_culled(step.outcome)) {
        return {0.72f, 0.72f, 0.72f};
    }
    if (step.end_test > step.first_test) {
        return tested_color;
    }
    return step.outcome == Outcome::leaf ? glm::vec3(0.62f, 0.80f, 0.74f)
                                         : glm::vec3(0.50f, 0.62f, 0.78f);
}

// How a shape looks.
struct Look {
    glm::vec3 color{0.0f};
    double opacity = 1.0;
    float width = 1.0f; // of lines, in pixels
    bool shaded = false;
    bool wireframe = false;
    vtkPlane* clip = nullptr; // hides what lies behind it
};

vtkSmartPointer<vtkActor> add_shape(vtkRenderer& renderer, const Shape& shape, const Look& look);

// The same, each cell in the colour of its value.
vtkSmartPointer<vtkActor> add_valued_shape(vtkRenderer& renderer, const Shape& shape,
                                           const Look& look, const ValueRange& range);

enum class Font { plain, bold, code };
enum class Side { left, center, right };

struct Writing {
    glm::vec3 color = ink;
    int size = 15; // of the letters, in pixels
    Font font = Font::plain;
    Side side = Side::left;            // which side of the text is at the place
    bool boxed = false;                // on its own sheet
    std::optional<glm::vec3> ground{}; // a colour behind the letters, where lines may cross them
};

// Text with its lower left corner at that place of the window, in pixels; with several lines, the
// upper left.
void write(vtkRenderer& renderer, const std::string& text, const glm::ivec2& place,
           const Writing& writing);

// Fills a part of the window.
void fill(vtkRenderer& renderer, const Area& area, const glm::vec3& color);

// The largest font size, from 9 to `most`, at which the longest line fits into so many pixels; a
// letter is about half as wide as its size.
int size_to_fit(const std::string& text, int width, int most);

// Makes the renderer draw into that part of the window.
void place_renderer(vtkRenderer& renderer, const Area& area, const glm::ivec2& window);

} // namespace raysteps::view
