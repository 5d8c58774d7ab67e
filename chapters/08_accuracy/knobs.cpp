#include "knobs.h"

#include "grid_knob.h"
#include "hit_picture_knob.h"
#include "image_knobs.h"
#include "offset_knob.h"
#include "precision_knob.h"
#include "primary_knob.h"
#include "slab_knob.h"
#include "speed_knob.h"
#include "triangle_knob.h"

namespace raysteps {

const std::vector<KnobMaker>& knob_makers() {
    static const std::vector<KnobMaker> all{
        {"triangle",
         [](const KnobRequest& r) { return triangle_knob("triangle", r.mesh, r.effort); }},
        {"slivers",
         [](const KnobRequest& r) {
             return triangle_knob("triangle, slivers", slivers_subject(), r.effort);
         }},
        {"picture", [](const KnobRequest& r) { return hit_picture_knob(r.scene, r.effort); }},
        {"precision", [](const KnobRequest& r) { return precision_knob(r.effort); }},
        {"slab", [](const KnobRequest& r) { return slab_knob(r.effort); }},
        {"offset", [](const KnobRequest& r) { return offset_knob(r.effort); }},
        {"primary", [](const KnobRequest& r) { return primary_knob(r.effort); }},
        {"grid", [](const KnobRequest& r) { return grid_knob(r.effort); }},
        {"samples", [](const KnobRequest& r) { return samples_knob(r.effort); }},
        {"depth", [](const KnobRequest& r) { return depth_knob(r.effort); }},
        {"lamp", [](const KnobRequest& r) { return lamp_knob(r.effort); }},
        {"speed", [](const KnobRequest& r) { return speed_knob(r.scene->scene, r.effort); }}};
    return all;
}

} // namespace raysteps
