#pragma once

#include "visualizer/cell_choice.h"
#include "visualizer/layout.h"
#include "shapes.h"

#include <glm/vec3.hpp>
#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <optional>
#include <string>
#include <vector>

namespace raysteps::view {

// How a shape looks.
struct Look {
    glm::vec3 color{0.0f};
    double opacity = 1.0;
    float width = 1.0f; // of lines and points, in pixels
    bool shaded = false;
    bool wireframe = false;
    vtkPlane* clip = nullptr; // takes away what lies behind it
};

// The sRGB colour of a value in its range.
glm::vec3 color_in(const ValueRange& range, double value);

vtkSmartPointer<vtkActor> add_shape(vtkRenderer& renderer, const Shape& shape, const Look& look);

// The same, with the colours of the values of its cells.
vtkSmartPointer<vtkActor> add_valued_shape(vtkRenderer& renderer, const Shape& shape,
                                           const Look& look, const ValueRange& range);

enum class Font { plain, bold, code };
enum class Side { left, center, right };

struct Writing {
    glm::vec3 color{0.12f, 0.14f, 0.18f};
    int size = 15; // of the letters, in pixels
    Font font = Font::plain;
    Side side = Side::left;            // which side of the text the place is
    bool boxed = false;                // on a sheet of its own
    std::optional<glm::vec3> ground{}; // a colour behind the letters, where lines may cross them
};

// Text with its lower left corner at that place of the window, in pixels; with several lines, the
// upper left.
void write(vtkRenderer& renderer, const std::string& text, const glm::ivec2& place,
           const Writing& writing);

// A filled part of the window.
void fill(vtkRenderer& renderer, const Area& area, const glm::vec3& color);

// As large as its longest line fits the width in pixels, from 9 to the most; a letter is about half
// of its size wide.
int size_to_fit(const std::string& text, int width, int most);

// Where a renderer draws.
void place_renderer(vtkRenderer& renderer, const Area& area, const glm::ivec2& window);

} // namespace raysteps::view
