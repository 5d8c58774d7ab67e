#include "render/effects/effects_renderer.h"

#include <algorithm>

namespace raysteps {

std::vector<std::pair<std::string, long>> kinds_of(const RayTally& tally) {
    return {{"primary", tally.camera},
            {"shadow", tally.shadow},
            {"soft shadow", tally.soft_shadow},
            {"shadow behind glass", tally.behind_glass},
            {"mirror", tally.mirror},
            {"refracted", tally.refracted},
            {"reflected by glass", tally.reflected_by_glass}};
}

long all_rays(const RayTally& tally) {
    long all = 0;
    for (const auto& [kind, count] : kinds_of(tally)) {
        all += count;
    }
    return all;
}

namespace {

constexpr std::size_t rays_per_row = 512;

float brightest(const glm::vec4& weight) {
    return std::max({weight.x, weight.y, weight.z});
}

// The texels of a branch, on the CPU.
struct Texels {
    explicit Texels(const Branch& branch)
        : origins(read_floats(branch.rays.origins)),
          directions(read_floats(branch.rays.directions)), weights(read_floats(branch.weights)),
          media(read_integers(*branch.media)) {}

    std::vector<glm::vec4> origins;
    std::vector<glm::vec4> directions;
    std::vector<glm::vec4> weights;
    std::vector<glm::uvec4> media;
};

void append(RayList& list, const Texels& texels, std::size_t i, std::int32_t target) {
    list.origins.push_back(texels.origins[i]);
    list.directions.push_back(texels.directions[i]);
    list.weights.push_back(texels.weights[i]);
    list.media.push_back(texels.media[i]);
    list.targets.push_back(target);
}

// The part of the values, and nothing (zeros) behind it up to that size.
template <class Value>
std::vector<Value> part_of(const std::vector<Value>& values, std::size_t first, std::size_t count,
                           std::size_t size) {
    const auto begin = values.begin() + first;
    std::vector<Value> part(begin, begin + count);
    part.resize(size, Value(0));
    return part;
}

Branch upload_part(const RayList& list, std::size_t first, std::size_t count, int bounce) {
    const std::size_t width = std::min(count, rays_per_row);
    const std::size_t height = (count + width - 1) / width;
    Branch branch = make_branch(static_cast<int>(width), static_cast<int>(height), Media::kept);
    const std::size_t size = width * height;
    write_texels(branch.rays.origins, part_of(list.origins, first, count, size));
    write_texels(branch.rays.directions, part_of(list.directions, first, count, size));
    write_texels(branch.weights, part_of(list.weights, first, count, size));
    write_texels(*branch.media, part_of(list.media, first, count, size));
    branch.targets = part_of(list.targets, first, count, count);
    branch.live = std::make_unique<LiveMask>(static_cast<int>(width), static_cast<int>(height));
    branch.bounce = bounce;
    return branch;
}

} // namespace

Branch make_branch(int width, int height, Media media) {
    Branch branch{make_ray_textures(width, height),
                  Texture(TexelFormat::rgba32f, width, height),
                  std::nullopt,
                  nullptr,
                  {}};
    if (media == Media::kept) {
        branch.media.emplace(TexelFormat::rgba32ui, width, height);
    }
    return branch;
}

Gathered gather(const Branch& first, const Branch& second, const Branch& parent, float faintest) {
    const Texels firsts(first);
    const Texels seconds(second);
    Gathered gathered;
    for (std::size_t i = 0; i < firsts.weights.size(); ++i) {
        const bool has_first = brightest(firsts.weights[i]) > faintest;
        const bool has_second = brightest(seconds.weights[i]) > faintest;
        const bool is_faint = brightest(seconds.weights[i]) > 0.0f && !has_second;
        gathered.second_sent += has_second ? 1 : 0;
        gathered.second_faint += is_faint ? 1 : 0;
        if (!has_first && !has_second) {
            continue;
        }
        const std::int32_t target =
            parent.targets.empty() ? static_cast<std::int32_t>(i) : parent.targets[i];
        if (has_first) {
            append(gathered.list, firsts, i, target);
        }
        if (has_second) {
            append(gathered.list, seconds, i, target);
        }
    }
    return gathered;
}

std::vector<Branch> upload_list(const RayList& list, int bounce) {
    std::vector<Branch> pieces;
    for (std::size_t first = 0; first < list.targets.size(); first += most_rays_per_piece) {
        const std::size_t count = std::min(most_rays_per_piece, list.targets.size() - first);
        pieces.push_back(upload_part(list, first, count, bounce));
    }
    return pieces;
}

} // namespace raysteps
