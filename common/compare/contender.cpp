#include "compare/contender.h"

#include "embree/embree_scene.h"
#include "structure/families.h"
#include "structure/reach.h"

#include <memory>

namespace raysteps {

namespace {

std::map<std::string, std::string> own_values(const StructureFamily& family,
                                              const std::map<std::string, std::string>& values) {
    std::map<std::string, std::string> own;
    for (const BuildOption& option : family.options) {
        const auto value = values.find(option.name);
        if (value != values.end()) {
            own.insert(*value);
        }
    }
    return own;
}

std::size_t count_differences(std::span<const Hit> hits, const RaySet& rays) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        different += is_same_answer(hits[i], rays.expected[i], rays.kind.query) ? 0 : 1;
    }
    return different;
}

// Embree rounds in its own way: what is compared is the triangle, or whether there is any hit.
std::size_t count_other_triangles(const EmbreeScene& embree, const RaySet& rays, EmbreeCall call) {
    std::size_t different = 0;
    if (rays.kind.query == Query::any) {
        const std::vector<std::uint8_t> answers = embree.any_hits(rays.kind.rays, call);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            different += (answers[i] != 0) == (rays.expected[i].triangle >= 0) ? 0 : 1;
        }
        return different;
    }
    const std::vector<Hit> hits = embree.nearest_hits(rays.kind.rays, call);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        different += hits[i].triangle == rays.expected[i].triangle ? 0 : 1;
    }
    return different;
}

void run_embree(const EmbreeScene& embree, const RaySet& rays, EmbreeCall call) {
    if (rays.kind.query == Query::any) {
        embree.any_hits(rays.kind.rays, call);
    } else {
        embree.nearest_hits(rays.kind.rays, call);
    }
}

} // namespace

BuiltFamilies build_families(const Scene& scene, const std::vector<std::string>& structures,
                             const std::map<std::string, std::string>& values) {
    BuiltFamilies built;
    for (const std::string& structure : structures) {
        const StructureFamily family = family_of(structure);
        if (built.count(family.name) == 0) {
            const float reach = reach_of(scene.camera.eye, scene.corners);
            built.emplace(
                family.name,
                upload(scene, family.build(scene.corners, {.reach = reach,
                                                           .values = own_values(family, values)})));
        }
    }
    return built;
}

Contender make_contender(const std::string& structure, TraceRays& walk,
                         const SceneTextures& scene) {
    return {.name = structure,
            .facts = scene.structure.facts,
            .run =
                [&](const RaySet& rays) {
                    trace(walk, scene, rays.textures, rays.kind.query); // ends with a query
                },
            .count_different =
                [&](const RaySet& rays) {
                    const Texture hits = trace(walk, scene, rays.textures, rays.kind.query);
                    return count_differences(read_hits(hits, rays.kind.rays.size()), rays);
                }};
}

std::vector<Contender> make_embree(const Scene& scene, EmbreePart part) {
    if (part == EmbreePart::none) {
        return {};
    }
    const auto embree = std::make_shared<EmbreeScene>(
        scene.corners, part == EmbreePart::fast ? EmbreeMode::fast : EmbreeMode::robust);
    std::vector<Contender> contenders;
    for (const auto& [name, call] : {std::pair{embree_single, EmbreeCall::one_by_one},
                                     std::pair{embree_packets, EmbreeCall::packets}}) {
        contenders.push_back(
            {.name = name,
             .facts = {{"build_seconds", embree->build_seconds()}},
             .run = [embree, how = call](const RaySet& rays) { run_embree(*embree, rays, how); },
             .count_different =
                 [embree, how = call](const RaySet& rays) {
                     return count_other_triangles(*embree, rays, how);
                 }});
    }
    return contenders;
}

} // namespace raysteps
