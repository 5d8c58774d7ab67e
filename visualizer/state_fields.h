#pragma once

#include "state.h"

#include <string>

namespace raysteps::view {

// A field of the state, for people: its name in saved files, the option that sets it (empty where
// none does), and what --help says about that option.
struct Field {
    std::string name;
    std::string option;
    std::string meaning;
};

// Calls visit(field, member) for each field. Saved files, options and --help all come from here;
// the choices of a field are the words of its type, and its default is that of State.
template <class Visit>
void visit_fields(const Visit& visit) {
    const auto field = [&](const char* name, auto member, const char* option = "",
                           const char* meaning = "") {
        visit(Field{name, option, meaning}, member);
    };
    field("scene", &State::scene, "SCENE",
          "a model (.obj, .ply, .stl, .gltf, .glb, ...), a .toml file, or a sample scene");
    field("scale_exponent", &State::scale_exponent, "--scale-exponent",
          "multiply all lengths of the file, of --camera and of --ray by 2 to this power, for a "
          "model that is too small for floats");
    field("hard_case", &State::hard_case, "--hard-case",
          "show this hard case, such as K3, instead of a scene, with a ray that breaks a common "
          "method");
    field("hard_ray", &State::hard_ray, "--hard-ray",
          "which of the hard case's rays to show, from 0; by default the most telling one");
    field("structures", &State::structures, "--structure",
          "structures to show side by side, separated by commas; each can have its own builder "
          "options, as in bvh_ordered:split=median");
    field("build_values", &State::build_values);
    field("camera", &State::camera, "--camera",
          "the camera that traces the picture, as in all chapters");
    field("placed", &State::placed);
    field("up", &State::up, "--up", "the axis of a model from a file that points up");
    field("picture", &State::picture, "--size", "size of the traced picture in pixels");
    field("pixel", &State::pixel, "--pixel",
          "show the ray of this pixel: column,row from top left");
    field("ray", &State::ray, "--ray",
          "show this ray: ox,oy,oz,dx,dy,dz, optionally followed by t_min,t_max");
    field("steps", &State::steps, "--steps",
          "show the walk of this file of recorded steps beside ours, where they part");
    field("bounces", &State::bounces, "--bounces", "at most this many mirror rays behind a pixel");
    field("path_ray", &State::path_ray, "--path-ray",
          "which ray behind the pixel to step through; 0 is the camera ray");
    field("step", &State::step);
    field("why", &State::why, "--why",
          "say why the ray does not come to this triangle: which box left it out, and by how much");
    field("model", &State::model, "--model", "how to draw the model");
    field("show", &State::filter, "--show", "which cells to draw");
    field("color", &State::color, "--color", "what the colour of a cell shows");
    field("levels", &State::levels, "--levels", "levels of the tree to draw, as in 3 or 2-5");
    field("opacity", &State::opacity, "--opacity", "opacity of the faces of cells, 0 to 1");
    field("most_cells", &State::most_cells, "--most-cells", "draw at most this many cells");
    field("clip", &State::clip, "--clip",
          "hide what lies behind a plane: a point x,y,z and a normal x,y,z");
    field("heat_map", &State::heat_map, "--heat-map", "show the work per pixel of the picture");
    field("own_scales", &State::own_scales, "--own-scales",
          "give each of several heat maps a scale of its own, instead of one for all");
    field("table", &State::table);
    field("sort_by", &State::sort_by, "--table", "show a table of the cells, sorted by this");
    field("descending", &State::descending);
    field("first_row", &State::first_row);
    field("selected", &State::selected, "--select", "mark the cell of this number");
    field("help", &State::help, "--help-sheet", "show the keys and their current values");
    field("viewpoint", &State::viewpoint, "--viewpoint",
          "where to look from, written like --camera");
    field("window", &State::window, "--window-size", "size of the window in pixels");
}

} // namespace raysteps::view
