#include "catch.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "path_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

using namespace raysteps;

namespace {

// The pairs of a picture of 16 x 16 pixels, as start_paths draws them: a view of the unit square
// makes a pixel's place its direction, and 16 divides without rounding.
template <class Numbers>
void check_same_bits(const std::string& random) {
    const auto context = make_context(ContextKind::automatic);
    constexpr int side = 16;
    constexpr int seed = 7;
    Program program("pass/path/start_paths.frag", {{"random", "random/" + random + ".glsl"}});
    program.set("view.right", glm::vec3(1.0f, 0.0f, 0.0f))
        .set("view.up", glm::vec3(0.0f, 1.0f, 0.0f))
        .set("picture_width", side)
        .set("picture_height", side)
        .set("pictures_across", 2)
        .set("first_sample", 48)
        .set("seed", seed);
    Texture origins(TexelFormat::rgba32f, 2 * side, 2 * side);
    Texture directions(TexelFormat::rgba32f, 2 * side, 2 * side);
    Texture weights(TexelFormat::rgba32f, 2 * side, 2 * side);
    draw(program, {.textures = {origins, directions, weights}});
    const std::vector<glm::vec4> texels = read_floats(directions);

    Numbers mirror{};
    mirror.seed = seed;
    mirror.picture_width = side;
    mirror.picture_height = side;
    mirror.pictures_across = 2;
    mirror.first_sample = 48;
    int different = 0;
    for (int y = 0; y < 2 * side; ++y) {
        for (int x = 0; x < 2 * side; ++x) {
            const auto path = mirror.sample_at(x, y);
            const auto point = mirror.random_point(path.pixel, path.sample_number, 0);
            const glm::vec4 texel = texels[static_cast<std::size_t>(y * 2 * side + x)];
            const float s = (static_cast<float>(path.column) + point.x) / side;
            const float t = (static_cast<float>(path.row) + point.y) / side;
            different += std::bit_cast<unsigned>(texel.x) != std::bit_cast<unsigned>(s) ||
                                 std::bit_cast<unsigned>(texel.y) != std::bit_cast<unsigned>(t)
                             ? 1
                             : 0;
        }
    }
    CHECK(different == 0);
}

// A pair of one mirror as a place of the other.
mirror::PcgNumbers::SquarePoint cosine_place(mirror::SobolNumbers& numbers, int i) {
    const auto point = numbers.random_point(0, i, 0);
    return {point.x, point.y};
}

// The largest distance of a pair of random numbers' distribution from the even one, in one axis:
// Kolmogorov's statistic.
double unevenness(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    double largest = 0.0;
    const auto count = static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        largest = std::max({largest, std::abs(static_cast<double>(values[i]) - i / count),
                            std::abs(static_cast<double>(values[i]) - (i + 1.0) / count)});
    }
    return largest * std::sqrt(count);
}

} // namespace

TEST_CASE("the hash is PCG's output function after one step of its generator", "[11][random]") {
    // state = 2891336453 for 0, and its bits are then permuted: by a few lines of Python.
    mirror::PcgNumbers numbers{};
    CHECK(numbers.hashed(0u) == 129708002u);
    CHECK(numbers.hashed(1u) == 2831084092u);
    std::set<unsigned> values;
    for (unsigned i = 0; i < 65536; ++i) {
        values.insert(numbers.hashed(i << 7U));
    }
    CHECK(values.size() == 65536); // no two numbers to one
}

TEST_CASE("random numbers have the same bits on the GPU and in C++", "[11][random]") {
    check_same_bits<mirror::PcgNumbers>("pcg");
    check_same_bits<mirror::SobolNumbers>("sobol");
}

TEST_CASE("numbers by chance fill the unit interval evenly, along samples and along pixels",
          "[11][random]") {
    mirror::PcgNumbers numbers{};
    numbers.seed = 3;
    std::vector<float> along_samples;
    std::vector<float> along_pixels;
    for (int i = 0; i < 10000; ++i) {
        along_samples.push_back(numbers.random_point(5, i, 2).x);
        along_pixels.push_back(numbers.random_point(i, 5, 2).y);
    }
    // Over 2.6 in one of 10^6 (Kolmogorov's distribution: 2 exp(-2 * 2.6^2) = 2.7e-6).
    CHECK(unevenness(along_samples) < 2.6);
    CHECK(unevenness(along_pixels) < 2.6);
}

TEST_CASE("pairs of one sample do not depend on each other", "[11][random]") {
    // The correlation of n independent pairs is within 4.9 / sqrt(n) but for one in 10^6.
    mirror::PcgNumbers numbers{};
    numbers.seed = 3;
    constexpr int count = 20000;
    double pairs = 0.0;
    double pixels = 0.0;
    double inside = 0.0;
    for (int i = 0; i < count; ++i) {
        const auto a = numbers.random_point(9, i, 4);
        const auto b = numbers.random_point(9, i, 5);
        const auto c = numbers.random_point(10, i, 4);
        const auto centred = [](float value) { return static_cast<double>(value) - 0.5; };
        pairs += 12.0 * centred(a.x) * centred(b.x);
        pixels += 12.0 * centred(a.x) * centred(c.x);
        inside += 12.0 * centred(a.x) * centred(a.y);
    }
    const double bound = 4.9 * std::sqrt(static_cast<double>(count));
    CHECK(std::abs(pairs) < bound);
    CHECK(std::abs(pixels) < bound);
    CHECK(std::abs(inside) < bound);
}

TEST_CASE("each box of one shape has one of Sobol's pairs, in every block of every pixel",
          "[11][random]") {
    mirror::SobolNumbers numbers{};
    for (const int seed : {0, 1, 77}) {
        numbers.seed = seed;
        for (const int first : {0, 64, 4096}) {
            for (int columns = 1; columns <= 64; columns *= 2) {
                std::vector<int> boxes(64, 0);
                for (int i = first; i < first + 64; ++i) {
                    const auto point = numbers.random_point(seed + 12, i, 3);
                    const int rows = 64 / columns;
                    const int column = static_cast<int>(point.x * static_cast<float>(columns));
                    const int row = static_cast<int>(point.y * static_cast<float>(rows));
                    ++boxes[static_cast<std::size_t>(row * columns + column)];
                }
                CAPTURE(seed, first, columns);
                CHECK(std::ranges::count(boxes, 1) == 64);
            }
        }
    }
}

TEST_CASE("the shares of both ways to a lamp sum to one", "[11][light]") {
    mirror::PcgNumbers power{};
    mirror::SobolNumbers balance{};
    for (const float light : {1e-6f, 0.1f, 1.0f, 30.0f, 1e12f}) {
        for (const float bounce : {1e-6f, 0.3f, 1.0f, 1e9f}) {
            CAPTURE(light, bounce);
            CHECK(power.share_of_light(light, bounce) + power.share_of_bounce(bounce, light) ==
                  Approx(1.0f));
            CHECK(balance.share_of_light(light, bounce) + balance.share_of_bounce(bounce, light) ==
                  Approx(1.0f));
        }
    }
}

TEST_CASE("a direction about a normal keeps its length and its height", "[11][light]") {
    mirror::PcgNumbers paths{};
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1),
                                   glm::vec3(0.6f, 0, -0.8f), glm::vec3(-0.48f, 0.6f, 0.64f)}) {
        const glm::vec3 local(0.36f, 0.48f, 0.8f);
        const glm::vec3 turned = paths.about_normal(normal, local);
        CHECK(glm::dot(turned, normal) == Approx(0.8f).margin(1e-6));
        CHECK(glm::length(turned) == Approx(1.0f).margin(1e-6));
    }
}

TEST_CASE("directions by the cosine have the mean height 2/3, even ones 1/2", "[11][light]") {
    mirror::PcgNumbers by_cosine{};
    mirror::SobolNumbers even{};
    double high = 0.0;
    double middle = 0.0;
    constexpr int count = 4096;
    for (int i = 0; i < count; ++i) {
        high += static_cast<double>(by_cosine.bounce_direction(cosine_place(even, i)).z);
        middle += static_cast<double>(even.bounce_direction(even.random_point(0, i, 0)).z);
    }
    CHECK(high / count == Approx(2.0 / 3.0).margin(0.002));
    CHECK(middle / count == Approx(0.5).margin(0.002));
}
