#pragma once

namespace raysteps::view {

// Whether there is a screen that a window can open on. VTK itself would end the program where there
// is none.
bool has_display();

} // namespace raysteps::view
