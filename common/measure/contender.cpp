#include "compare/contender.h"

#include "embree/embree_scene.h"

#include <memory>

namespace raysteps {

namespace {

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
                    return count_other_answers(read_hits(hits, rays.kind.rays.size()),
                                               rays.expected, rays.kind.query);
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
