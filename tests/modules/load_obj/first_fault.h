#pragma once

#include "scene/scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <string>

// What a scene from a file must hold to, whatever the file said: the first fault, or nothing.

// The sum of three rounded squares and a rounded normal: each component is right to 2^-24 relative,
// so the length is right to about 2^-24 = 6e-8; 2e-7 leaves room for the length's own rounding.
inline bool has_unit_length(const glm::vec3& normal) {
    return std::abs(glm::length(glm::dvec3(normal)) - 1.0) < 2e-7;
}

inline bool is_bounded(const glm::vec3& corner) {
    const float greatest = 1.8e18f;
    return glm::all(glm::lessThanEqual(glm::abs(corner), glm::vec3(greatest)));
}

inline bool is_between(const glm::vec3& color, float least, float greatest) {
    return glm::all(glm::greaterThanEqual(color, glm::vec3(least))) &&
           glm::all(glm::lessThanEqual(color, glm::vec3(greatest)));
}

inline std::string first_fault(const raysteps::Material& material) {
    if (!is_between(material.diffuse, 0, 1) || !is_between(material.specular, 0, 1) ||
        !is_between(material.transmission, 0, 1))
        return "a reflectance is not between 0 and 1";
    if (!is_between(material.emission, 0, 1e6f))
        return "an emission is out of range";
    if (!(material.shininess >= 0 && material.shininess <= 1e6f))
        return "a shininess is out of range";
    if (!(material.refractive_index >= 0.001f && material.refractive_index <= 10))
        return "a refractive index is out of range";
    if (!(material.opacity >= 0 && material.opacity <= 1))
        return "an opacity is out of range";
    if (material.illumination_model < 0 || material.illumination_model > 10)
        return "an illumination model is out of range";
    return material.name.empty() ? "a material has no name" : "";
}

inline std::string first_fault(const raysteps::Scene& scene) {
    const auto triangles = static_cast<std::size_t>(triangle_count(scene));
    if (scene.corners.size() != 3 * triangles || scene.normals.size() != 3 * triangles ||
        (!scene.texture_coordinates.empty() && scene.texture_coordinates.size() != 3 * triangles) ||
        scene.triangle_materials.size() != triangles)
        return "the lists differ in length";
    for (const glm::vec3& corner : scene.corners)
        if (!is_bounded(corner))
            return "a corner is too far away or no number";
    for (const glm::vec3& normal : scene.normals)
        if (!has_unit_length(normal))
            return "a normal has not length 1";
    for (const glm::vec2& place : scene.texture_coordinates)
        if (!std::isfinite(place.x) || !std::isfinite(place.y))
            return "a texture coordinate is not finite";
    if (scene.materials.empty())
        return "there is no material";
    for (const int material : scene.triangle_materials)
        if (material < 0 || material >= static_cast<int>(scene.materials.size()))
            return "a material index is out of range";
    for (const raysteps::Material& material : scene.materials)
        if (std::string fault = first_fault(material); !fault.empty())
            return fault;
    for (const std::string& message : scene.messages)
        if (message.empty() || message.back() != '.')
            return "a message is no whole sentence";
    if (triangles == 0 && scene.messages.empty())
        return "an empty scene says nothing";
    return {};
}
