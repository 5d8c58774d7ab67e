#pragma once

#include "program/show.h"
#include "trace/trace_options.h"

#include <functional>
#include <string>
#include <vector>

namespace raysteps {

// What a window offers of a program that traces: the walk (W), the triangle test (T) and the view
// (V). A choice changes the value that it was made of, and calls `make`, which makes what renders;
// where that throws, the value is what it was. F5 calls `make` as well. A click gives the command
// that shows the pixel's ray in the visualizer. All references must live as long as the window.
LiveOffer live_trace(const PictureOptions& picture, const Scene& scene, TraceOptions& tracing,
                     std::string& view, const std::function<void()>& make);

// The same without a view.
LiveOffer live_trace(const PictureOptions& picture, const Scene& scene, TraceOptions& tracing,
                     const std::function<void()>& make);

// One of these numbers, or the value. `make` is as above.
LiveChoice number_choice(const std::string& name, char key, std::vector<int> numbers, int& value,
                         const std::function<void()>& make);

} // namespace raysteps
