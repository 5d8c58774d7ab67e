#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace raysteps {

// A surface that only scatters light.
inline Material matte(const std::string& name, const glm::vec3& diffuse) {
    Material material;
    material.name = name;
    material.diffuse = diffuse;
    return material;
}

// A surface that also mirrors, with the specular colour (illumination model 3).
inline Material mirror_material(const std::string& name, const glm::vec3& diffuse,
                                const glm::vec3& specular) {
    Material material = matte(name, diffuse);
    material.specular = specular;
    material.shininess = 200.0f;
    material.illumination_model = 3;
    return material;
}

// Clear glass (illumination model 7) of that refractive index, with a highlight. Of light that goes
// through one unit of length of it, `kept` is left.
inline Material glass(const std::string& name, float index, const glm::vec3& kept) {
    Material material = matte(name, glm::vec3(0.0f));
    material.specular = glm::vec3(0.9f);
    material.shininess = 400.0f;
    material.refractive_index = index;
    material.transmission = kept;
    material.illumination_model = 7;
    return material;
}

// A matte surface with a highlight (illumination model 2).
inline Material glossy(const std::string& name, const glm::vec3& diffuse, float specular,
                       float shininess) {
    Material material = matte(name, diffuse);
    material.specular = glm::vec3(specular);
    material.shininess = shininess;
    material.illumination_model = 2;
    return material;
}

// A matte surface with a texture, which may be one made by code: `made:bricks`.
inline Material painted(const std::string& name, const std::string& texture) {
    Material material = matte(name, glm::vec3(1.0f));
    material.diffuse_map = texture;
    return material;
}

// A lamp that one sees.
inline Material glowing(const std::string& name, const glm::vec3& emission) {
    Material material = matte(name, glm::vec3(0.0f));
    material.emission = emission;
    return material;
}

// A mountain of 2 * 4^depth triangles under four mirrors, which are balls of 1,280 triangles: the
// "mount" of Haines, "A proposal for standard graphics environments", 1987, with mirrors for glass.
Scene sample_mount(int depth);

// The scene with texture coordinates for its triangles from `first` on, as if the texture, `size`
// wide and high, were laid on each from the axis that its plane faces most.
Scene map_flat(Scene scene, int first, float size);

// The scene with texture coordinates for its triangles from `first` on, as longitude and latitude
// around the center: the whole texture once around, its upper edge at the pole +y.
Scene map_around(Scene scene, int first, const glm::vec3& center);

// The Stanford bunny (Turk and Levoy, 1994) from Debian's package glmark2-data. The camera and the
// lights are left to be placed. Throws InputError where the package is not installed.
Scene sample_bunny();

// One compact object: a ball of 20 * size * size triangles of nearly equal size.
// The camera and the lights are left to be placed.
Scene sample_compact(int size);

// The Cornell box with its two blocks, in millimetres: the measured geometry, camera and
// reflectances of "Cornell Box Data", Program of Computer Graphics, Cornell University, 1998. 32
// triangles. The lamp hangs 0.8 mm under the ceiling, since it would coincide with it, and a point
// light is added under it; a dim one at the camera stands in for what the walls scatter. The blocks
// have no bottom, which would coincide with the floor.
Scene sample_cornell_box();

// A box after the Cornell box with a mirror ball and a glass ball in it, under a lamp with an area:
// it calls for most effects.
Scene sample_glass_box();

// The Stanford bunny of green glass on a checkered floor under a sky. Throws InputError where the
// package with the bunny is not installed.
Scene sample_glass_bunny();

// A dense knot of 1,024 * size * size triangles: every box around a part of it is full of others.
// The camera and the lights are left to be placed.
Scene sample_knot(int size);

// A row of balls that runs away from a camera with a wide lens: only the red one is sharp.
Scene sample_lens();

// Mirror balls and a tall mirror among coloured solids on a checkered floor, under two lights:
// 1,492 triangles, few enough to test every one of them for every ray. The mirrors see each other.
Scene sample_mirrors();

// `count` long thin triangles in all directions through the cube from -1 to 1: 50 to 5,000 times as
// long as they are wide, so that their boxes are nearly empty. The same seed gives the same bits on
// every machine. The camera and the lights are left to be placed.
Scene sample_needles(int count, int seed);

// A globe, a box and a floor with textures on them (made by code), before a wall of bricks.
Scene sample_pictures();

// An interior that calls for every effect but the lens: a table with glass on it before a wall of
// bricks, a mirror, a window to the sky, and a lamp with an area.
Scene sample_room();

// Matte solids under one wide lamp: shadows that grow softer with the distance.
Scene sample_soft_light();

// `count` random triangles in the cube from -1 to 1, as small as is needed to keep their density.
// The same seed gives the same bits on every machine. The camera and the lights are left to be
// placed.
Scene sample_soup(int count, int seed);

// A ball with nine smaller balls on it, which have nine balls each, and so on `depth` times, over a
// floor: the "balls" of Haines, "A proposal for standard graphics environments", 1987.
// The first ball has 1,280 triangles, each of the next nine 320, all smaller ones 80.
Scene sample_sphereflake(int depth);

// A knot of 1,024 * size * size triangles, a few decimetres wide, on the pitch of a stadium that is
// 200 metres long and has 2,152 triangles: the "teapot in a stadium" of Haines (Ray Tracing News),
// which a uniform grid cannot resolve. In metres. The camera stands before the knot.
Scene sample_stadium(int size);

// Sierpinski's tetrahedron, 4^(depth + 1) triangles: the "tetra" of Haines, "A proposal for
// standard graphics environments", 1987. The camera and the lights are left to be placed.
Scene sample_tetrahedron(int depth);

// A cross-section of a tube: a circle around center, through the tips of the unit vectors right and
// up, which are perpendicular to each other and to the tube's direction right x up.
struct TubeSection {
    glm::dvec3 center{0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
};

// A closed tube that runs through the sections and back to the first, with `sides` quadrilaterals
// around: 2 * sections.size() * sides triangles with smooth normals.
Mesh closed_tube(const std::vector<TubeSection>& sections, double radius, int sides);

// A tube along the torus knot that winds seven times around the torus' axis and sixteen times
// around its ring: 1,024 * size * size triangles. It fits in a box of about 4.1 * 4.1 * 1.6 around
// the origin.
Mesh torus_knot(int size);

// Heights at the crossings of a square grid, row by row: (cells + 1) * (cells + 1) numbers.
struct HeightField {
    int cells = 1;
    std::vector<float> heights;
};

float height_at(const HeightField& field, int column, int row);

// A random mountain of 2^depth * 2^depth cells with its corners at 0: midpoints are moved by random
// amounts that halve from level to level (Fournier, Fussell and Carpenter, "Computer rendering of
// stochastic models", 1982). The same seed gives the same bits.
HeightField random_mountain(int depth, int seed);

} // namespace raysteps
