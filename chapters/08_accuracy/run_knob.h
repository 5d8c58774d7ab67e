#pragma once

#include "knob.h"

#include <functional>

namespace raysteps {

// Which clock tells how long something took: that on the wall, or the processor time of this
// process, which is steadier where others use the machine too, but knows nothing of a GPU.
enum class Clock { wall, processor };

// Measures all methods of a knob. The trials of a family take turns: each round has every method
// once, so that what slows the machine for a while slows them all; the first round is dropped. Then
// each is examined. Throws InputError where there is no round, and Error with exit code 1 where two
// methods of a family do not have the same number of cases to work on, or where a knob that must
// not change answers has a fault.
KnobResult run_knob(const Knob& knob, int rounds, Clock clock,
                    const std::function<void(double part_done)>& progress);

} // namespace raysteps
