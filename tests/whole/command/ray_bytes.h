#pragma once

#include <array>
#include <cstring>
#include <string>
#include <vector>

// A ray of a binary ray file: origin, direction, t_min, t_max.
using RayNumbers = std::array<float, 8>;

// 32 bytes a ray, as docs/ray_files.md has it.
inline std::string ray_bytes(const std::vector<RayNumbers>& rays) {
    std::string bytes(rays.size() * sizeof(RayNumbers), '\0');
    if (!rays.empty()) {
        std::memcpy(bytes.data(), rays.data(), bytes.size());
    }
    return bytes;
}

// One triangle in the plane z = 0, and one in the plane z = -1 below it.
inline const std::string two_triangles =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nv 1 0 -1\nv 0 1 -1\nf 1 2 3\nf 4 5 6\n";
