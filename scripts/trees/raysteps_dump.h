// Writes what Raysteps reads of other programs: trees, hits and rays (docs/tree_files.md,
// docs/ray_files.md). C++17, one header, no dependencies; for little-endian machines.
#ifndef RAYSTEPS_DUMP_H
#define RAYSTEPS_DUMP_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace raysteps_dump {

// A field of a node: `type` is "float32" or one of "int8" to "uint64", `at` its first byte.
struct Field {
    std::string name;
    std::string type;
    std::size_t at;
    std::size_t values;
};

// Records as they lie in memory.
struct Array {
    std::string name;
    const void* data;
    std::size_t count;
    std::size_t stride;
    std::vector<Field> fields;
};

// Any kind of tree: `members` are those of the head but for "arrays", as JSON, as in
// "\"kind\": \"bvh\", \"triangles\": \"scene\"". Whether the file was written.
inline bool arrays(const std::string& path, const std::string& members,
                   const std::vector<Array>& all) {
    std::string head = "{" + members + ", \"arrays\": {";
    std::string data;
    for (const Array& array : all) {
        data.resize((data.size() + 15) / 16 * 16, '\0');
        head += (data.empty() ? "\"" : ", \"") + array.name +
                "\": {\"at\": " + std::to_string(data.size()) +
                ", \"count\": " + std::to_string(array.count) +
                ", \"stride\": " + std::to_string(array.stride) + ", \"fields\": [";
        for (std::size_t i = 0; i < array.fields.size(); ++i) {
            const Field& field = array.fields[i];
            head += (i == 0 ? "{\"name\": \"" : ", {\"name\": \"") + field.name +
                    "\", \"type\": \"" + field.type + "\", \"at\": " + std::to_string(field.at) +
                    ", \"values\": " + std::to_string(field.values) + "}";
        }
        head += "]}";
        data.append(static_cast<const char*>(array.data), array.count * array.stride);
    }
    head += "}}\n";
    const std::uint64_t size = head.size();
    std::string bytes = "raysteps tree 1\n";
    bytes.append(reinterpret_cast<const char*>(&size), sizeof(size));
    bytes += head;
    bytes.resize((bytes.size() + 15) / 16 * 16, '\0');
    std::ofstream file(path, std::ios::binary);
    file << bytes << data;
    file.close();
    return static_cast<bool>(file);
}

// A hierarchy of boxes: nodes of one struct, and the triangle numbers that its leaves refer to.
// `links` is "pair", "indices" or "skip". Where the triangles' corners are given, nine floats each,
// the numbers count these; else those of the scene that Raysteps loads.
inline bool tree(const std::string& path, int children_per_node, const std::string& links,
                 const void* nodes, std::size_t node_count, std::size_t node_bytes,
                 const std::vector<Field>& fields, const std::uint32_t* triangles,
                 std::size_t triangle_count, const float* corners = nullptr,
                 std::size_t corner_triangles = 0, const std::string& more_members = "") {
    std::vector<Array> all{{"nodes", nodes, node_count, node_bytes, fields},
                           {"order", triangles, triangle_count, 4, {{"triangle", "uint32", 0, 1}}}};
    if (corners != nullptr) {
        all.push_back({"corners", corners, corner_triangles, 36, {{"points", "float32", 0, 9}}});
    }
    return arrays(path,
                  "\"kind\": \"bvh\", \"triangles\": \"" +
                      std::string(corners != nullptr ? "inside" : "scene") +
                      "\", \"children_per_node\": " + std::to_string(children_per_node) +
                      ", \"links\": \"" + links + "\"" +
                      (more_members.empty() ? "" : ", " + more_members),
                  all);
}

// A hit for each ray of a file: -1 is the triangle of a miss.
inline bool hits(const std::string& path, const float* t, const float* u, const float* v,
                 const std::int32_t* triangles, std::size_t count) {
    std::ofstream file(path, std::ios::binary);
    for (std::size_t i = 0; i < count; ++i) {
        const float numbers[3] = {t[i], u[i], v[i]};
        file.write(reinterpret_cast<const char*>(numbers), sizeof(numbers));
        file.write(reinterpret_cast<const char*>(&triangles[i]), sizeof(triangles[i]));
    }
    file.close();
    return static_cast<bool>(file);
}

// Rays: three floats of the origin and of the direction, t_min and t_max.
inline bool rays(const std::string& path, const float* eight_each, std::size_t count) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(eight_each), static_cast<std::streamsize>(32 * count));
    file.close();
    return static_cast<bool>(file);
}

} // namespace raysteps_dump

#endif
