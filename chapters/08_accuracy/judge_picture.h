#pragma once

#include "knob.h"
#include "image/image.h"

namespace raysteps {

// How far a picture is from the true one: pixels that differ by more than one of the 256 steps of
// sRGB are faults; the error is that of each pixel in such steps, of the component that differs
// most; beside it stand the RMSE of the linear colours and the structural similarity.
Findings judge_picture(const Image& picture, const Image& truth);

// Where two pictures differ: the first one in grey, and red where they do by more than one step.
Image mark_differences(const Image& picture, const Image& truth);

} // namespace raysteps
