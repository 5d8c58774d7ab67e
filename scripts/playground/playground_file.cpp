#include "playground_file.h"

#include "program/output.h"
#include "scene/frame_scene.h"
#include "scene/pack_scene.h"
#include "scene/view.h"

#include <glm/geometric.hpp>

#include <bit>
#include <cstring>

namespace raysteps {

namespace {

constexpr int octants = 8;

Numbers triple(const glm::vec3& point) {
    return Numbers::List{point.x, point.y, point.z};
}

// The arrays, and what the head says of each: its name, its kind, and how many texels it has in the
// page. What the page can make of less is written as less.
class Arrays {
public:
    void add(Numbers& list, const std::string& name, std::span<const glm::vec3> vectors) {
        put(list, name, "float3", vectors.size(), std::as_bytes(vectors));
    }

    void add(Numbers& list, const std::string& name, std::span<const std::int32_t> integers) {
        put(list, name, "int1", integers.size(), std::as_bytes(integers));
    }

    void add(Numbers& list, const std::string& name, const std::vector<glm::vec4>& texels) {
        // A child's box is its parent's, with the plane between the children as one side.
        const bool from_nodes = name == "kd_boxes";
        put(list, name, from_nodes ? "kd_boxes" : "float4", texels.size(),
            std::as_bytes(std::span(texels).first(from_nodes ? 0 : texels.size())));
    }

    void add(Numbers& list, const std::string& name, std::span<const glm::ivec4> texels) {
        if (name == "bvh_triangles") {
            add_leaves(list, name, texels);
        } else if (name == "bvh_nodes") {
            // The other octants are the same nodes in another order.
            const auto one = texels.first(texels.size() / octants);
            put(list, name, "octants", texels.size(), std::as_bytes(one));
        } else {
            put(list, name, "int4", texels.size(), std::as_bytes(texels));
        }
    }

    const std::string& bytes() const { return bytes_; }

private:
    // The corners are the scene's: only each triangle's number and whether it ends a leaf are new.
    void add_leaves(Numbers& list, const std::string& name, std::span<const glm::ivec4> texels) {
        std::vector<std::int32_t> order;
        for (std::size_t i = 0; i < texels.size(); i += 3) {
            order.push_back(2 * texels[i].w + texels[i + 1].w);
        }
        put(list, name, "leaves", texels.size(), std::as_bytes(std::span(order)));
    }

    void put(Numbers& list, const std::string& name, const char* kind, std::size_t texels,
             std::span<const std::byte> bytes) {
        list.push_back({{"name", name},
                        {"kind", kind},
                        {"texels", texels},
                        {"start", bytes_.size()},
                        {"bytes", bytes.size()}});
        bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }

    std::string bytes_;
};

Numbers family_head(const StructureFamily& family, const Scene& scene, const BuildRequest& request,
                    Arrays& arrays) {
    const BuiltStructure built = family.build(scene.corners, request);
    Numbers list = empty_list();
    for (const auto& [name, texels] : built.packed.vectors) {
        arrays.add(list, name, texels);
    }
    for (const auto& [name, texels] : built.packed.integer_vectors) {
        arrays.add(list, name, texels);
    }
    for (const auto& [name, integers] : built.packed.integers) {
        // The page has the parents from the order of octant 0.
        if (name != "bvh_parents") {
            arrays.add(list, name, integers);
        }
    }
    Numbers points = empty_object();
    for (const auto& [name, point] : built.packed.points) {
        points[name] = triple(point);
    }
    Numbers counts = empty_object();
    for (const auto& [name, count] : built.packed.counts) {
        counts[name] = Numbers::List{count.x, count.y, count.z};
    }
    Numbers numbers = empty_object();
    for (const auto& [name, number] : built.packed.numbers) {
        numbers[name] = number;
    }
    return {{"name", family.name}, {"arrays", list},     {"points", points},
            {"counts", counts},    {"numbers", numbers}, {"longest_walk", built.longest_walk}};
}

} // namespace

std::string playground_file(const Scene& scene, double aspect_ratio,
                            std::span<const StructureFamily> families,
                            const BuildRequest& request) {
    Arrays arrays;
    Numbers list = empty_list();
    arrays.add(list, "triangle_corners", scene.corners);
    arrays.add(list, "triangle_normals", scene.normals);
    arrays.add(list, "triangle_materials", scene.triangle_materials);
    arrays.add(list, "materials", pack_materials(scene.materials));
    arrays.add(list, "gloss_texels", pack_gloss(scene));
    Numbers heads = empty_list();
    for (const StructureFamily& family : families) {
        heads.push_back(family_head(family, scene, request, arrays));
    }
    Numbers lights = empty_list();
    for (const Light& light : scene.lights) {
        lights.push_back({{"position", triple(light.position)}, {"color", triple(light.color)}});
    }
    const View view = view_of(scene.camera, aspect_ratio);
    Numbers head{{"scene", scene.name},
                 {"scene_hash", hash_of(scene)},
                 {"triangles", triangle_count(scene)},
                 {"view", Numbers{{"eye", triple(view.eye)},
                                  {"lower_left", triple(view.lower_left)},
                                  {"right", triple(view.right)},
                                  {"up", triple(view.up)}}},
                 {"middle_distance", glm::distance(scene.camera.eye, scene.camera.target)},
                 {"background", triple(scene.background)},
                 {"lights", lights},
                 {"reach", request.reach},
                 {"arrays", list},
                 {"families", heads}};
    std::string text = head.to_json();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto length = static_cast<std::uint32_t>(text.size());
    static_assert(std::endian::native == std::endian::little);
    std::string bytes(sizeof length, '\0');
    std::memcpy(bytes.data(), &length, sizeof length);
    return bytes + text + arrays.bytes();
}

} // namespace raysteps
