#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// Looks from eye to target. The angle is the vertical field of view, in degrees, over 0 and under
// 180; eye and target differ, and up is not parallel to the line between them.
struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 5.0f};
    glm::vec3 target{0.0f, 0.0f, 0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float vertical_field_of_view = 40.0f;
    float aperture = 0.0f;       // of the lens, its diameter; 0 is a pinhole, which is all sharp
    float focus_distance = 0.0f; // of the sharp plane from the eye; 0 is the target's
    int samples = 0;             // rays per pixel; 0 is as many as the scene calls for
};

// A point that shines equally in all directions, and equally strong at every distance, as in the
// paper: a surface shows (N.L) * colour of the surface * colour of the light. With both edges it is
// a parallelogram around the position, and its colour is that of all its points together.
struct Light {
    glm::vec3 position{0.0f};
    glm::vec3 color{1.0f};
    glm::vec3 across{0.0f}; // the edges of the parallelogram; zero for a point
    glm::vec3 along{0.0f};
};

inline bool has_area(const Light& light) {
    return light.across != glm::vec3(0.0f) || light.along != glm::vec3(0.0f);
}

// What an MTL file says of a surface; the letters are the file's own (Wavefront, "MTL material
// format", 1995). Colours are linear RGB.
struct Material {
    std::string name = "default";
    glm::vec3 diffuse{0.8f};         // Kd
    glm::vec3 specular{0.0f};        // Ks: also the colour of a mirror
    float shininess = 0.0f;          // Ns
    glm::vec3 emission{0.0f};        // Ke
    float refractive_index = 1.0f;   // Ni
    float opacity = 1.0f;            // d, or 1 - Tr
    glm::vec3 transmission{1.0f};    // Tf
    int illumination_model = 1;      // illum
    std::string diffuse_map;         // map_Kd: path of the texture, empty where there is none
    std::string cutout_map;          // map_d: where its alpha (or grey) is low, there is no surface
    float cutoff = 0.5f;             // that is below this
    std::string normal_map;          // norm: bends the normals that the light sees
    std::string emissive_map;        // map_Ke: the surface glows by it, and lights no other
    glm::vec3 emissive_factor{1.0f}; // Ke where there is a map_Ke, and emission is black
};

// The illumination models 3 to 7 and 9 call for ray-traced reflection; without a specular colour it
// is black.
inline bool is_mirror(const Material& material) {
    const int model = material.illumination_model;
    return ((model >= 3 && model <= 7) || model == 9) && material.specular != glm::vec3(0.0f);
}

// What a material calls for, by the statements of its MTL file.

// The part of the light that a surface lets through: 1 - d where d is under 1; else all of it where
// the illumination model calls for transparency (4, 6, 7 and 9), and nothing where it does not.
float transparency(const Material& material);

inline bool is_glass(const Material& material) {
    return transparency(material) > 0.0f;
}

// Does it absorb light on the way through (Tf)?
inline bool absorbs(const Material& material) {
    return is_glass(material) && material.transmission != glm::vec3(1.0f);
}

// The illumination models from 2 on call for highlights; without a colour or an exponent there
// are none.
inline bool has_highlight(const Material& material) {
    return material.illumination_model >= 2 && material.specular != glm::vec3(0.0f) &&
           material.shininess > 0.0f;
}

inline bool has_texture(const Material& material) {
    return !material.diffuse_map.empty();
}

// What a ray sees that leaves the scene, by its direction: the horizon where it runs level, the
// zenith straight up, the ground straight down, and mixtures between. Linear RGB.
struct Sky {
    glm::vec3 zenith{0.0f};
    glm::vec3 horizon{0.0f};
    glm::vec3 ground{0.0f};
};

// A model file in a scene, and where it stands.
struct Model {
    std::string path;
    glm::mat4 transform{1.0f};
};

// A run of triangles that are one object of a model's file, from the first on to the next run.
struct NamedRun {
    int first_triangle = 0;
    int model = 0;      // of Scene::models
    std::string object; // its name in the file: o or g of an OBJ file, the node of a glTF file
    int primitive = -1; // its number in the object, where the file counts them
};

// A picture that lies in a model's file; materials name it as they name a file.
struct EnclosedPicture {
    std::string name;
    std::string bytes; // of a picture file: PNG, JPEG, ...
};

// Everything that a picture needs, in world space. Triangle i has the corners, normals and texture
// coordinates 3i, 3i + 1 and 3i + 2; triangles are numbered in the order of their file. A scene of
// files that give no texture coordinates has none.
// Every number is finite, every material index is in range, and materials is never empty.
struct Scene {
    std::string name;
    std::vector<glm::vec3> corners;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texture_coordinates;
    std::vector<int> triangle_materials;
    std::vector<Material> materials;
    std::vector<Light> lights;
    Camera camera;
    glm::vec3 background{0.0f};
    std::optional<Sky> sky;    // where there is one, it takes the place of the background
    std::vector<Model> models; // where the triangles came from; empty for a sample scene
    // Triangles that the models' files have and the scene has not, since they are no triangles at
    // all: their numbers, if they were counted too, ascending.
    std::vector<int> left_out;
    std::vector<std::string> messages; // what the user should know about how it was loaded
    glm::dvec3 origin{0.0};            // was taken from every coordinate of the files
    std::vector<NamedRun> runs;        // in the order of their triangles
    std::vector<int> faces;            // of each triangle: its face in its file, from 1; or empty
    std::vector<glm::vec3> corner_colors; // linear RGB, times Kd; or empty
    std::vector<EnclosedPicture> enclosed;
    std::optional<Camera> file_camera; // the first that a model's file has
};

// `ear.obj, object "left", face 12`: what the files call a triangle; empty for a sample scene.
std::string name_of_triangle(const Scene& scene, int triangle);

// For each run, the triangles and faces that are its own, a line each; empty for a sample scene.
std::vector<std::string> describe_runs(const Scene& scene);

inline int triangle_count(const Scene& scene) {
    return static_cast<int>(scene.corners.size() / 3);
}

// Sixteen digits that tell whether two scenes are the same to a ray and to the light: FNV-1a
// (Fowler, Noll and Vo) over the bits of triangles, normals, texture coordinates, materials, lights
// and background, in this order on every machine. The camera, names and folders do not count; of a
// texture its file name does.
std::string hash_of(const Scene& scene);

} // namespace raysteps
