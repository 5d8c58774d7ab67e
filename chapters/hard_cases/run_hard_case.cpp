#include "trials.h"

#include "gpu/shaders.h"
#include "mirror/trace_by_mirror.h"
#include "reference/exact.h"
#include "structure/padding.h"
#include "structure/structure.h"
#include "structure/tree_file/tree_file.h"
#include "tally.h"

#include <algorithm>

namespace raysteps {

namespace {

constexpr int rays_per_batch = 1 << 18; // what textures and buffers hold at a time

// One batch of a case with everything that its methods need.
struct Batch {
    HardScene made;
    Scene scene;
    mirror::SceneBuffers buffers;
    std::map<std::string, BuiltStructure> built; // by family
    std::vector<Hit> loop;                       // what decides
};

float reach_for(const HardCase& hard_case, const HardScene& made) {
    return hard_case.truth == Truth::answered ? 0.0f : reach_of(made.rays, made.mesh.corners);
}

// Those whose walks go through such a tree; of no file, all.
std::vector<std::string> families_for(const std::string& file) {
    if (file.empty()) {
        std::vector<std::string> all;
        for (const StructureFamily& family : list_families()) {
            all.push_back(family.name);
        }
        return all;
    }
    const AnyTree tree = read_tree_file(file).tree;
    if (const auto* const boxes = std::get_if<BoxTree>(&tree)) {
        return boxes->width == 2 ? std::vector<std::string>{"bvh", "bvh4"}
                                 : std::vector<std::string>{"bvh4"};
    }
    return {std::holds_alternative<KdTree>(tree) ? "kd" : "grid"};
}

Batch make_batch(const HardCase& hard_case, const HardRequest& request, const std::string& file) {
    HardScene made = hard_case.make(request);
    Scene scene = add_mesh(Scene{}, made.mesh, Material{});
    std::map<std::string, BuiltStructure> built;
    for (const std::string& name : families_for(file)) {
        BuildRequest build{.reach = reach_for(hard_case, made)};
        if (!file.empty()) {
            build.values["tree"] = file;
        } else if (const auto values = made.build_values.find(name);
                   values != made.build_values.end()) {
            build.values = values->second;
        }
        built.emplace(name, family_of(name).build(made.mesh.corners, build));
    }
    Batch batch{
        std::move(made), std::move(scene), mirror::SceneBuffers(Scene{}), std::move(built), {}};
    batch.buffers = mirror::SceneBuffers(batch.scene);
    batch.loop = mirror_triangle_tests().at("watertight")(batch.buffers, {}, batch.made.rays);
    return batch;
}

std::string promise_of(Truth truth) {
    switch (truth) {
    case Truth::all_hit:
        return "every ray hits";
    case Truth::all_miss:
        return "every ray misses";
    case Truth::exact:
        return "the exact triangle";
    case Truth::the_loop:
        return "enough hits";
    case Truth::answered:
        break;
    }
    return "an answer";
}

// How many hits of a triangle test are not the truth.
std::size_t count_untrue(const HardCase& hard_case, const Batch& batch, std::span<const Hit> hits) {
    const auto hit_count = static_cast<std::size_t>(std::count_if(
        hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle != no_triangle; }));
    switch (hard_case.truth) {
    case Truth::all_hit:
        return hits.size() - hit_count;
    case Truth::all_miss:
        return hit_count;
    case Truth::exact: {
        const std::vector<ReferenceHit> exact =
            exact_nearest_hits(batch.made.rays, batch.made.mesh.corners);
        std::size_t untrue = 0;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            untrue += hits[i].triangle == exact[i].triangle ? 0 : 1;
        }
        return untrue;
    }
    case Truth::the_loop:
        return hit_count < batch.made.least_hits ? batch.made.least_hits - hit_count : 0;
    case Truth::answered:
        break;
    }
    return count_unanswered(hits, triangle_count(batch.scene));
}

// How many hits of a structure are not those of the loop.
std::size_t count_unlike(const HardCase& hard_case, const Batch& batch, std::span<const Hit> hits,
                         std::span<const Hit> loop) {
    return hard_case.truth == Truth::answered ? count_unanswered(hits, triangle_count(batch.scene))
                                              : count_other_hits(hits, loop);
}

void try_triangle_tests(const HardCase& hard_case, const Batch& batch, Tallies& tallies) {
    for (const auto& [name, trace] : mirror_triangle_tests()) {
        const bool is_default = name == "watertight";
        if (!is_default && hard_case.tries == Tries::structures) {
            continue;
        }
        const std::vector<Hit> hits =
            is_default ? batch.loop : trace(batch.buffers, {}, batch.made.rays);
        const bool promised = is_default && hard_case.guarantee == Guarantee::promised;
        tallies.add({name, "C++", promise_of(hard_case.truth), promised}, hits.size(),
                    count_untrue(hard_case, batch, hits));
    }
}

std::string bits_of_loop(const HardCase& hard_case) {
    return hard_case.truth == Truth::answered ? "an answer" : "the loop's bits";
}

void try_structures(const HardCase& hard_case, const Batch& batch, Tallies& tallies) {
    for (const NamedPart& part : list_parts("structure")) {
        const auto walk = mirror_walks().find(part.name);
        if (part.name == "every_triangle" || walk == mirror_walks().end()) {
            continue; // a walk that somebody has just written is tried on the GPU only
        }
        const auto built = batch.built.find(family_of(part.name).name);
        if (built == batch.built.end()) {
            continue;
        }
        const std::vector<Hit> hits =
            walk->second(batch.buffers, built->second.packed, batch.made.rays);
        tallies.add({part.name, "C++", bits_of_loop(hard_case), true}, hits.size(),
                    count_unlike(hard_case, batch, hits, batch.loop));
    }
}

void try_gpu(const HardCase& hard_case, const Batch& batch, GpuMethods& gpu, Tallies& tallies) {
    RayTextures rays = upload_rays(batch.made.rays);
    rays.coherence = Coherence::neighbours; // so that packets trace all of them
    const std::size_t count = batch.made.rays.size();
    const SceneTextures bare = upload(batch.scene);
    std::vector<Hit> loop;
    for (const NamedPart& part : list_parts("triangle")) {
        const bool is_default = part.name == "watertight";
        if (!is_default && hard_case.tries == Tries::structures) {
            continue;
        }
        const std::vector<Hit> hits = gpu.trace(part.name, "every_triangle", bare, rays, count);
        const bool promised = is_default && hard_case.guarantee == Guarantee::promised;
        tallies.add({part.name, "GPU", promise_of(hard_case.truth), promised}, count,
                    count_untrue(hard_case, batch, hits));
        loop = is_default ? hits : loop;
    }
    if (hard_case.truth != Truth::answered) {
        tallies.add({"watertight", "GPU", "the bits of C++", true}, count,
                    count_other_hits(loop, batch.loop));
    }
    std::map<std::string, SceneTextures> built;
    const auto try_structure = [&](const std::string& structure) {
        const std::string family = family_of(structure).name;
        if (!batch.built.contains(family)) {
            return;
        }
        if (!built.contains(family)) {
            built.emplace(family, upload(batch.scene, batch.built.at(family)));
        }
        const std::vector<Hit> hits =
            gpu.trace("watertight", structure, built.at(family), rays, count);
        tallies.add({structure, "GPU", bits_of_loop(hard_case), true}, count,
                    count_unlike(hard_case, batch, hits, loop));
    };
    for (const NamedPart& part : list_parts("structure")) {
        if (part.name != "every_triangle") {
            try_structure(part.name);
        }
    }
    for (const NamedPart& part : list_parts("packet")) {
        try_structure(part.name);
    }
}

} // namespace

std::vector<TrialRow> run_hard_case(const HardCase& hard_case, const TrialTools& tools) {
    const int wanted = tools.rays > 0 ? tools.rays : usual_rays;
    const int rays = std::min(wanted, hard_case.most_rays);
    Tallies tallies;
    for (int done = 0, seed = tools.seed; done < rays; done += rays_per_batch, ++seed) {
        tools.progress(static_cast<double>(done) / rays);
        const Batch batch =
            make_batch(hard_case, {std::min(rays_per_batch, rays - done), seed}, tools.tree);
        if (tools.by_mirror) {
            try_triangle_tests(hard_case, batch, tallies);
            try_structures(hard_case, batch, tallies);
        }
        if (tools.gpu != nullptr) {
            try_gpu(hard_case, batch, *tools.gpu, tallies);
        }
    }
    tools.progress(1.0);
    return tallies.rows();
}

} // namespace raysteps
