#include "scene/sample_scenes.h"

#include "scene/sample_bunny.h"
#include "scene/sample_compact.h"
#include "scene/sample_cornell_box.h"
#include "scene/sample_glass_box.h"
#include "scene/sample_glass_bunny.h"
#include "scene/sample_knot.h"
#include "scene/sample_lens.h"
#include "scene/sample_mirrors.h"
#include "scene/sample_mount.h"
#include "scene/sample_needles.h"
#include "scene/sample_pictures.h"
#include "scene/sample_room.h"
#include "scene/sample_soft_light.h"
#include "scene/sample_soup.h"
#include "scene/sample_sphereflake.h"
#include "scene/sample_stadium.h"
#include "scene/sample_tetrahedron.h"

#include <limits>

namespace raysteps {

namespace {

using Values = std::vector<int>;

constexpr int greatest_seed = std::numeric_limits<int>::max();

} // namespace

const std::vector<SampleScene>& sample_scenes() {
    static const std::vector<SampleScene> scenes = {
        {"mirrors",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_mirrors(); },
         "mirror balls and coloured solids on a checkered floor"},
        {"cornell_box",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_cornell_box(); },
         "the measured Cornell box with its two blocks"},
        {"sphereflake",
         {{"DEPTH", 0, 5, 3}},
         SampleView::its_own,
         [](const Values& values) { return sample_sphereflake(values[0]); },
         "a ball with nine smaller balls on it, and so on"},
        {"tetrahedron",
         {{"DEPTH", 0, 10, 6}},
         SampleView::framed,
         [](const Values& values) { return sample_tetrahedron(values[0]); },
         "Sierpinski's tetrahedron"},
        {"mount",
         {{"DEPTH", 0, 10, 6}},
         SampleView::its_own,
         [](const Values& values) { return sample_mount(values[0]); },
         "a fractal mountain under four mirror balls"},
        {"compact",
         {{"SIZE", 1, 400, 32}},
         SampleView::framed,
         [](const Values& values) { return sample_compact(values[0]); },
         "a single ball of equal triangles"},
        {"knot",
         {{"SIZE", 1, 64, 8}},
         SampleView::framed,
         [](const Values& values) { return sample_knot(values[0]); },
         "a dense torus knot"},
        {"soup",
         {{"COUNT", 1, 20'000'000, 10'000}, {"SEED", 0, greatest_seed, 1}},
         SampleView::framed,
         [](const Values& values) { return sample_soup(values[0], values[1]); },
         "random triangles"},
        {"stadium",
         {{"SIZE", 1, 64, 8}},
         SampleView::its_own,
         [](const Values& values) { return sample_stadium(values[0]); },
         "a tiny dense knot in a large empty stadium"},
        {"needles",
         {{"COUNT", 1, 4'000'000, 2'000}, {"SEED", 0, greatest_seed, 1}},
         SampleView::framed,
         [](const Values& values) { return sample_needles(values[0], values[1]); },
         "long thin triangles in all directions"},
        {"bunny",
         {},
         SampleView::framed,
         [](const Values&) { return sample_bunny(); },
         "the Stanford bunny of Debian's package glmark2-data"},
        {"glass_box",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_glass_box(); },
         "a box with a mirror ball and a glass ball under a lamp with an area"},
        {"glass_bunny",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_glass_bunny(); },
         "the Stanford bunny of green glass on a checkered floor"},
        {"pictures",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_pictures(); },
         "a globe, a box, bricks and wood: surfaces with pictures"},
        {"soft_light",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_soft_light(); },
         "matte solids under one wide lamp"},
        {"lens",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_lens(); },
         "a row of balls before a camera with a wide lens"},
        {"room",
         {},
         SampleView::its_own,
         [](const Values&) { return sample_room(); },
         "an interior that calls for nearly every effect"},
    };
    return scenes;
}

} // namespace raysteps
