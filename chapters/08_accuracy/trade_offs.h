#pragma once

#include "basics/ray.h"
#include "gpu/shaders.h"
#include "structure/grid/grid.h"
#include "subject.h"
#include "trade_off.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace raysteps {

// What the comparisons are made on.
struct TradeOffRequest {
    std::shared_ptr<const Subject> mesh;  // of the families of aimed rays
    std::shared_ptr<const Subject> scene; // with the camera that pictures are made by
    Effort effort;
};

// A comparison that can be asked for by its name.
struct TradeOffMaker {
    std::string name;
    std::function<TradeOffTrials(const TradeOffRequest&)> make;
};

// All there are, in the order in which they are to be read.
const std::vector<TradeOffMaker>& trade_off_makers();

// For all of these a context must be current, as long as what they return lives.

// A triangle test: what fills the slots <triangle> and <real>.
struct TriangleMethod {
    std::string name;
    Parts parts;
};

const std::vector<TriangleMethod>& triangle_methods();

// All triangle tests, on families of rays at the subject (hard_cases/aimed_rays.h).
TradeOffTrials triangle_trade_off(const std::string& name,
                                  const std::shared_ptr<const Subject>& subject,
                                  const Effort& effort);

// What wrong hits look like: the rays of the subject's camera with each triangle test. The truth is
// the watertight test with exact areas.
TradeOffTrials hit_picture_trade_off(const std::shared_ptr<const Subject>& subject,
                                     const Effort& effort);

// A whole kernel, the walk through a hierarchy and its triangle test, in single and in double
// precision. Rays, boxes and triangles are floats in both.
TradeOffTrials precision_trade_off(const Effort& effort);

// Tests of a ray against a box (the parts of the slot <slab>), on rays aimed at corners of the
// boxes and along their sides. A miss of a box that the ray truly meets, by exact arithmetic, is a
// fault; a visit in vain is none, and is counted by itself.
TradeOffTrials slab_trade_off(const Effort& effort);

// How a ray gets off the surface that it starts on (the parts of the slot <offset>). Rays leave a
// sphere of triangles outwards, and must hit the shell around it: one that meets the sphere again
// makes acne, one that is beyond the shell from the start makes a leak. The same sphere stands in
// several units, and once far from zero. The error is how far the origin was moved off its point.
TradeOffTrials offset_trade_off(const Effort& effort);

// Where the rays of a picture come from: interpolated by the rasterizer as in the paper, or
// computed by each pixel. The error is that of the direction (reference/reference_ray.h), in ulp.
TradeOffTrials primary_trade_off(const Effort& effort);

// How a walk through a grid finds the next plane: from the index of the plane, or by adding up. A
// ray that visits other cells than it goes through is a fault, and so is a hit that gets lost.
TradeOffTrials grid_trade_off(const Effort& effort);

// Which cells a ray visits, as shaders/exhibit/trail_observer.glsl writes it down: how many, and a
// number for their order.
struct GridTrail {
    std::uint32_t visits = 0;
    std::uint32_t mixed = 2166136261U;
    bool is_close = false; // to an edge of a cell, so that floats cannot tell the order
};

// The trail of a ray that starts within the grid, by crossings that are computed in double from the
// planes of the grid, which are floats. Of equal crossings the first axis counts. A crossing in
// floats, (plane - origin) / direction, is rounded twice: by 2 e t, with e = 2^-24. So where two of
// them are within 4 e t of each other, and a fifth for the terms in e^2, either order is right, and
// a triangle that is listed by the padding of structure/padding.h is found in both.
GridTrail grid_trail(const GridShape& shape, const Ray& ray);

// Rays per pixel: 1, 4, 9 ... in a square; the truth has twice as many along each side as the most.
TradeOffTrials samples_trade_off(const Effort& effort);

// How many mirrors a path follows.
TradeOffTrials depth_trade_off(const Effort& effort);

// Points that stand for a lamp with an area: 1, 4, 16; the truth has 64.
TradeOffTrials lamp_trade_off(const Effort& effort);

// Choices that change the speed and the memory, and no answer: bins, leaf sizes, resolutions, the
// precision of nodes, room in the box test. The rays are the camera's and random ones; every hit
// must be that of bvh_ordered, bit for bit.
TradeOffTrials speed_trade_off(const Scene& scene, const Effort& effort);

} // namespace raysteps
