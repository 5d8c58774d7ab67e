#pragma once

namespace raysteps {

// What an observer is told.
struct WalkEvent {
    enum class Kind { visit, test };

    Kind kind;
    int number; // of the place or the triangle
};

} // namespace raysteps
