#include "catch.h"
#include "path_pictures.h"
#include "support/error_of.h"
#include "support/scratch_folder.h"

#include "basics/random_numbers.h"

#include <limits>

using namespace raysteps;

namespace {

Scene small_cornell_box() {
    return load_scene("cornell_box", 1.0f);
}

PathSums part_of(PathRenderer& renderer, const Scene& scene, int side, const BlockRange& blocks) {
    PathSums sums({.scene = scene.name, .width = side, .height = side});
    for (int block = blocks.first; block < blocks.end; ++block) {
        add_block(sums, block, renderer.render_block(scene.camera, side, side, block));
    }
    return sums;
}

void check_same(const PathSums& a, const PathSums& b) {
    CHECK(a.sums == b.sums);
    CHECK(a.squares == b.squares);
    CHECK(a.largest == b.largest);
    CHECK(samples_in_words(a.blocks) == samples_in_words(b.blocks));
}

} // namespace

TEST_CASE("an exact sum does not depend on its order", "[11][sums]") {
    const int seed = GENERATE(1, 2, 3);
    CAPTURE(seed);
    RandomNumbers random(seed);
    std::vector<double> values;
    for (int i = 0; i < 1000; ++i) {
        values.push_back(
            std::ldexp(static_cast<double>(random.unit()) - 0.5, random.below(40) - 20));
    }
    ExactSum forward;
    ExactSum backward;
    for (std::size_t i = 0; i < values.size(); ++i) {
        forward.add(values[i]);
        backward.add(values[values.size() - 1 - i]);
    }
    CHECK(forward == backward);
}

TEST_CASE("an exact sum of floats is exact", "[11][sums]") {
    ExactSum sum;
    sum.add(1048575.0);
    sum.add(0x1p-52);
    sum.add(-1048575.0);
    CHECK(sum.value() == 0x1p-52);
    ExactSum thirds;
    for (int i = 0; i < 3; ++i) {
        thirds.add(static_cast<double>(1.0f / 3.0f));
    }
    CHECK(thirds.value() == 3.0 * static_cast<double>(1.0f / 3.0f));
}

TEST_CASE("a block has the same bits however many samples are traced side by side", "[11][sums]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = small_cornell_box();
    PathRenderer renderer = path_renderer(scene, {});
    const std::vector<glm::vec4> together = renderer.render_block(scene.camera, 12, 12, 3, 16);
    for (const int count : {1, 2, 8}) {
        CAPTURE(count);
        CHECK(renderer.render_block(scene.camera, 12, 12, 3, count) == together);
    }
    CHECK(renderer.render_block(scene.camera, 12, 12, 4, 16) != together);
    PathRenderer other_seed = path_renderer(scene, {.seed = 2});
    CHECK(other_seed.render_block(scene.camera, 12, 12, 3, 16) != together);
}

TEST_CASE("parts that are merged have the bits of the whole, in any order and through files",
          "[11][sums]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = small_cornell_box();
    PathRenderer renderer = path_renderer(scene, {});
    const PathSums whole = part_of(renderer, scene, 10, {0, 6});
    const PathSums first = part_of(renderer, scene, 10, {0, 1});
    const PathSums middle = part_of(renderer, scene, 10, {1, 4});
    const PathSums last = part_of(renderer, scene, 10, {4, 6});
    check_same(merged(merged(first, middle), last), whole);
    check_same(merged(merged(last, first), middle), whole);
    CHECK(samples_in_words(merged(first, last).blocks) == "0-15, 64-95");

    const ScratchFolder folder("path_sums");
    write_sums(folder / "middle.paths", middle);
    const PathSums again = read_sums(folder / "middle.paths");
    check_same(again, middle);
    CHECK(again.run == middle.run);

    CHECK_THAT(error_of([&] { merged(whole, middle); }),
               contains_text("sample 16: it would count twice"));
    PathSums other = last;
    other.run.choice = "other";
    CHECK_THAT(error_of([&] { merged(first, other); }), contains_text("of another run"));
    put_bytes(folder / "half.paths", bytes_of(folder / "middle.paths").substr(0, 5000));
    CHECK_THAT(error_of([&] { read_sums(folder / "half.paths"); }),
               contains_text("half.paths: this is no whole file of sums."));
}

TEST_CASE("a NaN, an infinite or an enormous sample is counted, with its place, and hidden nowhere",
          "[11][sums]") {
    PathSums sums({.width = 3, .height = 2});
    std::vector<glm::vec4> block(6, glm::vec4(16.0f));
    block[1].y = std::numeric_limits<float>::quiet_NaN();
    block[3].x = std::numeric_limits<float>::infinity();
    block[5].z = 16.0f * brightest_mean;
    add_block(sums, 0, block);
    CHECK(sums.broken_count == 3);
    REQUIRE(sums.broken.size() == 3);
    CHECK((sums.broken[2].column == 1 && sums.broken[2].row == 1)); // the bottom row comes first
    CHECK(mean_of(sums).at(0, 0) == glm::vec3(0.0f));
    CHECK(mean_of(sums).at(1, 0) == glm::vec3(1.0f));
    CHECK(mean_of(sums).at(2, 0) == glm::vec3(0.0f));
    CHECK(mean_of(sums).at(0, 1) == glm::vec3(1.0f));
}

TEST_CASE("a pixel that owes most of its light to one block is a firefly", "[11][sums]") {
    PathSums sums({.width = 2, .height = 1});
    for (int block = 0; block < 16; ++block) {
        std::vector<glm::vec4> samples(2, glm::vec4(16.0f));
        samples[1] *= block == 5 ? 40.0f : 1.0f;
        add_block(sums, block, samples);
    }
    const Fireflies fireflies = fireflies_of(sums);
    CHECK(fireflies.count == 1);
    CHECK((fireflies.column == 1 && fireflies.row == 0));
    CHECK(fireflies.block_mean == 40.0f);
    CHECK(mean_of(sums).at(1, 0).x == 55.0f / 16.0f); // it stays in the picture
}

TEST_CASE("the variance of a mean is that of its blocks", "[11][sums]") {
    PathSums sums({.width = 1, .height = 1});
    for (const float value : {1.0f, 3.0f, 5.0f, 7.0f}) {
        add_block(sums, static_cast<int>(value) / 2,
                  std::vector<glm::vec4>(1, glm::vec4(16.0f * value)));
    }
    // Values 1, 3, 5, 7: mean 4, variance 20 / 3, of the mean a quarter of it.
    CHECK(variance_of_mean(sums).front() == Approx(20.0 / 3.0 / 4.0));
    CHECK(estimated_error(sums) == Approx(std::sqrt(20.0 / 3.0 / 4.0) / 4.0));
    Image reference(1, 1);
    reference.pixels.front() = glm::vec3(5.0f, 4.0f, 3.0f);
    CHECK(relative_error(mean_of(sums), reference, sums.sees_lamp) ==
          Approx(std::sqrt(2.0 / 3.0) / 4.0));
}
