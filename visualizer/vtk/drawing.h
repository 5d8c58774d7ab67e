#pragma once

#include "visualizer/layout.h"
#include "visualizer/stage.h"
#include "shapes.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace raysteps::view {

// How much was drawn of one structure, counted from the shapes themselves.
struct DrawnPane {
    long cells = 0;    // boxes with a colour of their own
    long left_out = 0; // that are too many to draw
    long culled = 0;   // boxes that the walk left out
    long split_planes = 0;
    long tested = 0;    // triangles
    long hits = 0;      // triangles that are the walk's hit
    long intervals = 0; // of the ray in leaves
    long rays = 0;      // of the path
};

// Draws states into a window, whoever owns that: the one on a screen or the one without.
class Drawing {
public:
    explicit Drawing(vtkRenderWindow& window);

    // Everything anew; what has not changed is kept. Then the window is to be rendered.
    std::vector<DrawnPane> draw(const Stage& stage, const State& state);

    // The camera in space, one for all panes. It is that of the state, or frames the scene.
    Camera viewpoint() const;

    const std::vector<vtkSmartPointer<vtkRenderer>>& spaces() const { return spaces_; }

private:
    void arrange(const Stage& stage, const State& state);
    Camera camera_of(const Stage& stage, const State& state) const;
    void aim(const Camera& from);

    vtkRenderWindow& window_;
    Layout layout_;
    std::vector<vtkSmartPointer<vtkRenderer>> spaces_; // a structure each
    std::vector<vtkSmartPointer<vtkRenderer>> heat_maps_;
    vtkSmartPointer<vtkRenderer> side_;
    vtkSmartPointer<vtkRenderer> bottom_;
    vtkSmartPointer<vtkRenderer> sheet_; // over everything
    Shape model_;                        // of the scene with that many corners at that place
    const void* model_of_ = nullptr;
};

} // namespace raysteps::view
