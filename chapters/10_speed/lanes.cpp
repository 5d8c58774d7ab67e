#include "lanes.h"

#include "basics/error.h"
#include "image/color.h"
#include "image/heat_map.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace raysteps {

namespace {

// Calls `work` with the texels of each block that lie in the picture.
template <class Work>
void for_each_block(const CountedVisits& counted, const Work& work) {
    for (int bottom = 0; bottom < counted.height; bottom += block_rows) {
        for (int left = 0; left < counted.width; left += block_columns) {
            std::vector<std::size_t> texels;
            for (int row = bottom; row < std::min(bottom + block_rows, counted.height); ++row) {
                for (int column = left; column < std::min(left + block_columns, counted.width);
                     ++column) {
                    texels.push_back(static_cast<std::size_t>(row) *
                                         static_cast<std::size_t>(counted.width) +
                                     static_cast<std::size_t>(column));
                }
            }
            work(texels);
        }
    }
}

// A block that makes no round keeps nobody waiting.
std::vector<float> work_of_blocks(const CountedVisits& counted) {
    const std::vector<std::uint32_t> rounds = rounds_of_blocks(counted);
    std::vector<float> parts(rounds.size(), 1.0f);
    for_each_block(counted, [&](const std::vector<std::size_t>& texels) {
        double visits = 0.0;
        for (const std::size_t texel : texels) {
            visits += counted.visits[texel];
        }
        const double places = static_cast<double>(texels.size()) * rounds[texels.front()];
        for (const std::size_t texel : texels) {
            parts[texel] = places > 0.0 ? static_cast<float>(visits / places) : 1.0f;
        }
    });
    return parts;
}

// Values come bottom row first, a picture has the top one first.
Image draw_values(const std::vector<float>& values, int width, int height,
                  const HeatMapRange& range) {
    Image picture(width, height);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const std::size_t texel =
                static_cast<std::size_t>(height - 1 - row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column);
            picture.at(column, row) = color_map(fraction_of_range(values[texel], range));
        }
    }
    return picture;
}

// The pictures in one line with their captions, over the legend that they share.
Image draw_line_of(const std::vector<Image>& pictures, const std::vector<std::string>& captions,
                   const HeatMapRange& range, const std::string& title) {
    const Image line = side_by_side(pictures, captions);
    return stack(line, draw_legend(range, title, "", line.width));
}

double mean_of(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

std::vector<std::uint32_t> rounds_of_blocks(const CountedVisits& counted) {
    std::vector<std::uint32_t> rounds(counted.visits.size(), 0);
    for_each_block(counted, [&](const std::vector<std::size_t>& texels) {
        std::uint32_t longest = 0;
        for (const std::size_t texel : texels) {
            longest = std::max(longest, counted.visits[texel]);
        }
        for (const std::size_t texel : texels) {
            rounds[texel] = longest;
        }
    });
    return rounds;
}

double lanes_at_work(const CountedVisits& counted) {
    const std::vector<std::uint32_t> rounds = rounds_of_blocks(counted);
    double places = 0.0;
    for_each_block(counted, [&](const std::vector<std::size_t>& texels) {
        places += static_cast<double>(lanes_of_block) * rounds[texels.front()];
    });
    const double visits = std::accumulate(counted.visits.begin(), counted.visits.end(), 0.0);
    return places > 0.0 ? visits / places : 1.0;
}

Image draw_blocks(const std::vector<CountedWalk>& walks) {
    const CountedVisits& first = walks.front().counted;
    std::vector<std::vector<float>> rounds;
    std::vector<float> all;
    for (const auto& [name, counted] : walks) {
        if (counted.width != first.width || counted.height != first.height) {
            throw InputError("The pictures of " + walks.front().name + " and " + name +
                             " differ in size. Trace the same rays by both.");
        }
        const std::vector<std::uint32_t> own = rounds_of_blocks(counted);
        rounds.emplace_back(own.begin(), own.end());
        all.insert(all.end(), own.begin(), own.end());
    }
    const HeatMapRange of_rounds = auto_range(all, HeatMapScale::logarithmic);
    const HeatMapRange of_lanes{0.0f, 1.0f};
    std::vector<Image> above;
    std::vector<Image> below;
    std::vector<std::string> of_mean;
    std::vector<std::string> of_work;
    for (std::size_t i = 0; i < walks.size(); ++i) {
        const auto& [name, counted] = walks[i];
        above.push_back(draw_values(rounds[i], first.width, first.height, of_rounds));
        below.push_back(draw_values(work_of_blocks(counted), first.width, first.height, of_lanes));
        of_mean.push_back(fmt::format("{}: {:.1f} rounds", name, mean_of(rounds[i])));
        of_work.push_back(fmt::format("{}: {:.0f} %", name, 100.0 * lanes_at_work(counted)));
    }
    return stack(draw_line_of(above, of_mean, of_rounds,
                              "rounds of each 4 x 2 pixels: visits of the slowest ray"),
                 draw_line_of(below, of_work, of_lanes, "part of their lanes at work"));
}

} // namespace raysteps
