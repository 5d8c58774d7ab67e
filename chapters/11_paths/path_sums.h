#pragma once

#include "image/image.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// A sum of numbers whose bits do not depend on their order: it is kept in integers. A float of size
// 2^-29 or more is added exactly, a smaller one rounded to a multiple of 2^-52.
struct ExactSum {
    std::int64_t coarse = 0; // in units of 2^-8
    std::int64_t fine = 0;   // in units of 2^-52

    void add(double value);
    void add(const ExactSum& other);
    double value() const;
    bool operator==(const ExactSum&) const = default;
};

// A number as large as this, or NaN, is not added: it is counted.
inline constexpr float brightest_mean = 1048576.0f; // 2^20: its square fits an ExactSum too

// What all blocks of a run have in common: sums of different runs are not joined.
struct PathRun {
    std::string scene{}; // its name
    std::string hash{};
    std::string camera{};
    std::string choice{}; // of PathChoice, in words
    int width = 0;
    int height = 0;

    bool operator==(const PathRun&) const = default;
};

// Blocks first ... end - 1.
struct BlockRange {
    int first = 0;
    int end = 0;
};

// A block's mean in a pixel that is NaN, infinite or not under brightest_mean.
struct BrokenMean {
    int column = 0;
    int row = 0; // from the top
    int block = 0;
};

// The samples of a picture, block by block. Row 0 is the top one.
struct PathSums {
    PathRun run;
    std::vector<BlockRange> blocks; // ascending, without gaps where two meet
    std::vector<ExactSum> sums;     // of the mean of each block: three per pixel
    std::vector<ExactSum> squares;  // of the squares of these means
    std::vector<float> largest;     // of the means of the blocks, the brightest channel; per pixel
    std::vector<std::uint8_t> sees_lamp; // 1 where a pixel may see a lamp: it counts for no error
    std::vector<BrokenMean> broken{};    // at most most_broken of each part are kept
    std::int64_t broken_count = 0;

    explicit PathSums(PathRun what);
    int block_count() const;
};

inline constexpr std::size_t most_broken = 16;

// Adds a block as PathRenderer::render_block gives it. Each block once.
void add_block(PathSums& sums, int block, std::span<const glm::vec4> samples);

// The sums of both, bit for bit as if all blocks had been added to one. Throws InputError where
// they are of different runs, or have a block in common.
PathSums merged(PathSums a, const PathSums& b);

// The mean radiance of each pixel.
Image mean_of(const PathSums& sums);

// The variance of that mean in each pixel, over the three channels together, as the blocks differ:
// for numbers by chance an unbiased estimate, for Sobol's, whose blocks complete each other, an
// upper one in expectation. Row by row; needs two blocks, else all are 0.
std::vector<float> variance_of_mean(const PathSums& sums);

// The root mean square error of the picture by these variances, over its mean; lamps left out.
double estimated_error(const PathSums& sums);

// The root mean square difference of both pictures over the mean of the second, where
// `left_out` is 0.
double relative_error(const Image& image, const Image& reference,
                      std::span<const std::uint8_t> left_out);

// Pixels that owe more than half of their light to one block of 16 samples, of 8 blocks or more.
struct Fireflies {
    int count = 0;
    int column = 0; // of the brightest
    int row = 0;
    float block_mean = 0.0f;
};
Fireflies fireflies_of(const PathSums& sums);

// A file of sums, for merging: a line of JSON and integers. Throws InputError where it cannot be
// written, or is no such file.
void write_sums(const std::filesystem::path& path, const PathSums& sums);
PathSums read_sums(const std::filesystem::path& path);

// `0-63, 128-191`: the samples of the blocks.
std::string samples_in_words(const std::vector<BlockRange>& blocks);

} // namespace raysteps
