#pragma once

#include "shapes.h"
#include "visualizer/layout.h"
#include "visualizer/stage.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace raysteps::view {

// How much was drawn of one structure, counted from the shapes themselves.
struct DrawnPane {
    long cells = 0;    // boxes of the structure
    long left_out = 0; // boxes too many to draw
    long culled = 0;   // boxes that the walk left out
    long split_planes = 0;
    long tested = 0;    // triangles
    long hits = 0;      // triangles hit by the walk
    long intervals = 0; // pieces of the ray in leaves
    long rays = 0;      // of the path
};

// Draws states into a window, on a screen or without one.
class Drawing {
public:
    explicit Drawing(vtkRenderWindow& window);

    // Puts together what the window shows when it is rendered next.
    std::vector<DrawnPane> draw(const Stage& stage, const State& state);

    // The camera of all panes: that of the state, or one that frames the scene, until the mouse
    // moves it.
    Camera viewpoint() const;

    const std::vector<vtkSmartPointer<vtkRenderer>>& spaces() const { return spaces_; }

private:
    void arrange(const Stage& stage, const State& state);
    Camera camera_of(const Stage& stage, const State& state) const;
    void aim(const Camera& from);

    vtkRenderWindow& window_;
    Layout layout_;
    std::vector<vtkSmartPointer<vtkRenderer>> spaces_; // one per structure
    std::vector<vtkSmartPointer<vtkRenderer>> heat_maps_;
    vtkSmartPointer<vtkRenderer> side_;
    vtkSmartPointer<vtkRenderer> bottom_;
    vtkSmartPointer<vtkRenderer> sheet_; // over everything
    Shape model_;                        // of the scene whose corners are at model_of_
    const void* model_of_ = nullptr;
};

} // namespace raysteps::view
