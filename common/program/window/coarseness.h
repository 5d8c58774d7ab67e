#pragma once

namespace raysteps {

// How coarse a picture is: one of its pixels stands for a square of the window with so many pixels
// on a side. A power of two, and 1 is the full picture.

// Before any frame has been timed.
inline constexpr int first_coarseness = 8;

// The finest that a frame can have which takes a tenth of a second at most, after one that took
// so many seconds: half the coarseness has four times the pixels. At most 16.
int affordable_coarseness(int coarseness, double seconds);

// While the camera moves, frames are as coarse as it takes to keep up with it. `shown` is 0 where
// the window does not show yet what it should; once it rests the picture gets finer frame by frame.
int next_coarseness(int shown, int affordable);

// How long to wait for events before that frame, in seconds: not at all, or as long as the camera
// may still go on, or without end.
double wait_before_frame(int shown, double seconds_at_rest);

// The pixels of a picture along a side of the window.
int coarse_side(int side, int coarseness);

} // namespace raysteps
