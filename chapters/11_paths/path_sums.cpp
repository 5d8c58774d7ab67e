#include "11_paths/path_sums.h"

#include "11_paths/path_renderer.h"
#include "basics/error.h"
#include "basics/file.h"
#include "basics/numbers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace raysteps {

namespace {

constexpr double coarse_unit = 0x1p-8;
constexpr double fine_unit = 0x1p-52;
constexpr const char* file_kind = "Raysteps sums of paths 1";
constexpr std::uintmax_t most_bytes_of_sums = std::uintmax_t{1} << 33U;

float brightest(const glm::vec3& color) {
    return std::max({color.x, color.y, color.z});
}

std::size_t pixel_count(const PathRun& run) {
    return static_cast<std::size_t>(run.width) * static_cast<std::size_t>(run.height);
}

// Joins ranges that meet. They are ascending and have no block in common.
std::vector<BlockRange> joined(const std::vector<BlockRange>& ranges) {
    std::vector<BlockRange> result;
    for (const BlockRange& range : ranges) {
        if (!result.empty() && result.back().end == range.first) {
            result.back().end = range.end;
        } else {
            result.push_back(range);
        }
    }
    return result;
}

glm::dvec3 channels(const std::vector<ExactSum>& sums, std::size_t pixel) {
    return {sums[3 * pixel].value(), sums[3 * pixel + 1].value(), sums[3 * pixel + 2].value()};
}

double sum_of(const glm::dvec3& color) {
    return color.x + color.y + color.z;
}

} // namespace

void ExactSum::add(double value) {
    const double steps = std::floor(value / coarse_unit);
    coarse += static_cast<std::int64_t>(steps);
    fine += std::llround((value - steps * coarse_unit) / fine_unit);
}

void ExactSum::add(const ExactSum& other) {
    coarse += other.coarse;
    fine += other.fine;
}

double ExactSum::value() const {
    return static_cast<double>(coarse) * coarse_unit + static_cast<double>(fine) * fine_unit;
}

PathSums::PathSums(PathRun what)
    : run(std::move(what)), sums(3 * pixel_count(run)), squares(3 * pixel_count(run)),
      largest(pixel_count(run), 0.0f), sees_lamp(pixel_count(run), 0) {}

int PathSums::block_count() const {
    int count = 0;
    for (const BlockRange& range : blocks) {
        count += range.end - range.first;
    }
    return count;
}

void add_block(PathSums& sums, int block, std::span<const glm::vec4> samples) {
    sums.blocks.push_back({block, block + 1});
    std::ranges::sort(sums.blocks, {}, &BlockRange::first);
    sums.blocks = joined(sums.blocks);
    const int width = sums.run.width;
    for (std::size_t pixel = 0; pixel < sums.largest.size(); ++pixel) {
        const int column = static_cast<int>(pixel) % width;
        const int row = static_cast<int>(pixel) / width;
        const std::size_t texel =
            static_cast<std::size_t>(sums.run.height - 1 - row) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(column);
        const glm::vec3 mean = glm::vec3(samples[texel]) / static_cast<float>(samples_per_block);
        const bool fits = std::abs(mean.x) < brightest_mean && std::abs(mean.y) < brightest_mean &&
                          std::abs(mean.z) < brightest_mean;
        if (!fits) { // of NaN too
            ++sums.broken_count;
            if (sums.broken.size() < most_broken) {
                sums.broken.push_back({column, row, block});
            }
            continue;
        }
        for (int channel = 0; channel < 3; ++channel) {
            const auto value = static_cast<double>(mean[channel]);
            const std::size_t place = 3 * pixel + static_cast<std::size_t>(channel);
            sums.sums[place].add(value);
            sums.squares[place].add(value * value);
        }
        sums.largest[pixel] = std::max(sums.largest[pixel], brightest(mean));
    }
}

PathSums merged(PathSums a, const PathSums& b) {
    if (!(a.run == b.run)) {
        throw InputError("samples " + samples_in_words(b.blocks) + " are of another run than " +
                         samples_in_words(a.blocks) + " (" + b.run.scene + ", " + b.run.choice +
                         "; " + a.run.scene + ", " + a.run.choice +
                         "). Give all parts the same options.");
    }
    std::vector<BlockRange> blocks = a.blocks;
    blocks.insert(blocks.end(), b.blocks.begin(), b.blocks.end());
    std::ranges::sort(blocks, {}, &BlockRange::first);
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        if (blocks[i].first < blocks[i - 1].end) {
            throw InputError("two parts have sample " +
                             std::to_string(samples_per_block * blocks[i].first) +
                             ": it would count twice. Leave one of them out.");
        }
    }
    a.blocks = joined(blocks);
    for (std::size_t i = 0; i < a.sums.size(); ++i) {
        a.sums[i].add(b.sums[i]);
        a.squares[i].add(b.squares[i]);
    }
    for (std::size_t i = 0; i < a.largest.size(); ++i) {
        a.largest[i] = std::max(a.largest[i], b.largest[i]);
    }
    a.broken.insert(a.broken.end(), b.broken.begin(), b.broken.end());
    a.broken_count += b.broken_count;
    return a;
}

Image mean_of(const PathSums& sums) {
    Image image(sums.run.width, sums.run.height);
    const double part = 1.0 / std::max(1, sums.block_count());
    for (std::size_t pixel = 0; pixel < image.pixels.size(); ++pixel) {
        image.pixels[pixel] = glm::vec3(part * channels(sums.sums, pixel));
    }
    return image;
}

std::vector<float> variance_of_mean(const PathSums& sums) {
    std::vector<float> variances(sums.largest.size(), 0.0f);
    const int count = sums.block_count();
    if (count < 2) {
        return variances;
    }
    for (std::size_t pixel = 0; pixel < variances.size(); ++pixel) {
        const glm::dvec3 mean = channels(sums.sums, pixel) / static_cast<double>(count);
        const glm::dvec3 squares = channels(sums.squares, pixel) / static_cast<double>(count);
        const double spread = sum_of(squares - mean * mean) / 3.0;
        variances[pixel] = static_cast<float>(std::max(0.0, spread) / (count - 1));
    }
    return variances;
}

double estimated_error(const PathSums& sums) {
    const std::vector<float> variances = variance_of_mean(sums);
    double variance = 0.0;
    double light = 0.0;
    double pixels = 0.0;
    for (std::size_t pixel = 0; pixel < variances.size(); ++pixel) {
        if (sums.sees_lamp[pixel] == 0) {
            variance += static_cast<double>(variances[pixel]);
            light += sum_of(channels(sums.sums, pixel)) / (3.0 * sums.block_count());
            pixels += 1.0;
        }
    }
    return light > 0.0 ? std::sqrt(variance / pixels) / (light / pixels) : 0.0;
}

double relative_error(const Image& image, const Image& reference,
                      std::span<const std::uint8_t> left_out) {
    double squares = 0.0;
    double light = 0.0;
    double pixels = 0.0;
    for (std::size_t pixel = 0; pixel < reference.pixels.size(); ++pixel) {
        if (left_out[pixel] == 0) {
            const glm::dvec3 difference =
                glm::dvec3(image.pixels[pixel]) - glm::dvec3(reference.pixels[pixel]);
            squares += glm::dot(difference, difference) / 3.0;
            light += sum_of(glm::dvec3(reference.pixels[pixel])) / 3.0;
            pixels += 1.0;
        }
    }
    return light > 0.0 ? std::sqrt(squares / pixels) / (light / pixels) : 0.0;
}

Fireflies fireflies_of(const PathSums& sums) {
    Fireflies found;
    const int count = sums.block_count();
    constexpr int fewest_blocks = 8;
    for (std::size_t pixel = 0; count >= fewest_blocks && pixel < sums.largest.size(); ++pixel) {
        const glm::dvec3 all = channels(sums.sums, pixel);
        const auto largest = static_cast<double>(sums.largest[pixel]);
        if (largest <= 0.5 * std::max({all.x, all.y, all.z})) {
            continue;
        }
        ++found.count;
        if (sums.largest[pixel] > found.block_mean) {
            found.block_mean = sums.largest[pixel];
            found.column = static_cast<int>(pixel) % sums.run.width;
            found.row = static_cast<int>(pixel) / sums.run.width;
        }
    }
    return found;
}

std::string samples_in_words(const std::vector<BlockRange>& blocks) {
    std::string words;
    for (const BlockRange& range : blocks) {
        words += (words.empty() ? "" : ", ") + std::to_string(samples_per_block * range.first) +
                 "-" + std::to_string(samples_per_block * range.end - 1);
    }
    return words;
}

namespace {

template <class Value>
void append(std::string& bytes, std::span<const Value> values) {
    static_assert(std::endian::native == std::endian::little);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

// Takes as many values as there is room for off the front of the bytes.
template <class Value>
void take(std::string_view& bytes, std::vector<Value>& values) {
    const std::size_t size = values.size() * sizeof(Value);
    std::memcpy(values.data(), bytes.data(), size);
    bytes.remove_prefix(size);
}

Numbers pairs_of(const std::vector<BlockRange>& blocks) {
    Numbers list = empty_list();
    for (const BlockRange& range : blocks) {
        list.push_back(Numbers::List{range.first, range.end});
    }
    return list;
}

} // namespace

void write_sums(const std::filesystem::path& path, const PathSums& sums) {
    Numbers broken = empty_list();
    for (const BrokenMean& one : sums.broken) {
        broken.push_back(Numbers::List{one.column, one.row, one.block});
    }
    const Numbers head{{"kind", file_kind},         {"scene", sums.run.scene},
                       {"hash", sums.run.hash},     {"camera", sums.run.camera},
                       {"choice", sums.run.choice}, {"width", sums.run.width},
                       {"height", sums.run.height}, {"blocks", pairs_of(sums.blocks)},
                       {"broken", broken},          {"broken_count", sums.broken_count}};
    std::string bytes = head.to_json_line() + "\n";
    append(bytes, std::span<const ExactSum>(sums.sums));
    append(bytes, std::span<const ExactSum>(sums.squares));
    append(bytes, std::span<const float>(sums.largest));
    append(bytes, std::span<const std::uint8_t>(sums.sees_lamp));
    write_file(path, bytes);
}

PathSums read_sums(const std::filesystem::path& path) {
    const std::string file = read_file(path, most_bytes_of_sums);
    const std::size_t line = file.find('\n');
    const InputError none(path.string() + ": this is no whole file of sums. Give one that 11_paths "
                                          "--samples A-B has written.");
    if (line == std::string::npos || !file.starts_with(R"({"kind":")" + std::string(file_kind))) {
        throw none;
    }
    const Numbers head = parse_json(file.substr(0, line), path);
    const auto integer = [](const Numbers& number) { return static_cast<int>(number.number()); };
    const int width = integer(head.at("width"));
    const int height = integer(head.at("height"));
    check_size(path.string(), width, height);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::string_view bytes = std::string_view(file).substr(line + 1);
    if (bytes.size() != pixels * (6 * sizeof(ExactSum) + sizeof(float) + 1)) {
        throw none;
    }
    PathSums sums({.scene = head.at("scene").text(),
                   .hash = head.at("hash").text(),
                   .camera = head.at("camera").text(),
                   .choice = head.at("choice").text(),
                   .width = width,
                   .height = height});
    for (const Numbers& range : head.at("blocks").values()) {
        sums.blocks.push_back({integer(range.values().at(0)), integer(range.values().at(1))});
    }
    for (const Numbers& one : head.at("broken").values()) {
        const Numbers::List& place = one.values();
        sums.broken.push_back({integer(place.at(0)), integer(place.at(1)), integer(place.at(2))});
    }
    sums.broken_count = static_cast<std::int64_t>(head.at("broken_count").number());
    take(bytes, sums.sums);
    take(bytes, sums.squares);
    take(bytes, sums.largest);
    take(bytes, sums.sees_lamp);
    return sums;
}

} // namespace raysteps
