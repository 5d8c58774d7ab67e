#include "fault_files.h"

#include "basics/file.h"

#include <array>
#include <cstdio>

namespace raysteps {

namespace {

// Nine digits tell every float from its neighbours.
std::string to_text(float number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", static_cast<double>(number));
    return text.data();
}

std::string to_text(const glm::vec3& point, const std::string& separator) {
    return to_text(point.x) + separator + to_text(point.y) + separator + to_text(point.z);
}

std::string to_obj(const Mesh& mesh) {
    std::string text;
    for (const glm::vec3& corner : mesh.corners) {
        text += "v " + to_text(corner, " ") + "\n";
    }
    for (std::size_t i = 1; i + 2 <= mesh.corners.size(); i += 3) {
        text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " +
                std::to_string(i + 2) + "\n";
    }
    return text;
}

std::string to_csv(std::span<const Ray> rays) {
    std::string text = "origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,t_min,"
                       "t_max\n";
    for (const Ray& ray : rays) {
        text += to_text(ray.origin, ",") + "," + to_text(ray.direction, ",") + "," +
                to_text(ray.t_min) + "," + to_text(ray.t_max) + "\n";
    }
    return text;
}

} // namespace

std::vector<std::filesystem::path> write_fault(const FuzzFault& fault,
                                               const std::filesystem::path& folder) {
    const std::string name = "fuzz_" + std::to_string(fault.seed);
    const std::vector<std::filesystem::path> paths{folder / (name + ".obj"),
                                                   folder / (name + ".csv")};
    write_file(paths[0], to_obj(fault.made.mesh));
    write_file(paths[1], to_csv(fault.made.rays));
    return paths;
}

} // namespace raysteps
