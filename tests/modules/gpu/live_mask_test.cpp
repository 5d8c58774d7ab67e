#include "catch.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/live_mask.h"
#include "hit_texels.h"

using namespace raysteps;

namespace {

constexpr int mask_width = 6;
constexpr int mask_height = 4;

constexpr int hit = 0;
constexpr int miss = -1;

int miss_in_odd_columns(int column, int) {
    return column % 2 == 1 ? miss : hit;
}

int miss_in_lowest_row(int, int row) {
    return row == 0 ? miss : hit;
}

} // namespace

TEST_CASE("at first all pixels of a mask are live", "[gpu][live_mask]") {
    const auto context = make_context(ContextKind::automatic);
    const Program all("pass/select/select_all.frag");
    CHECK(count_live(LiveMask(mask_width, mask_height), all) == 24);
    CHECK(count_live(LiveMask(1, 1), all) == 1);
    CHECK(count_live(LiveMask(513, 3), all) == 1539);
}

TEST_CASE("only the pixels that the program draws are counted", "[gpu][live_mask]") {
    const auto context = make_context(ContextKind::automatic);
    const Texture hits = hit_texels(mask_width, mask_height, miss_in_lowest_row);
    Program misses("pass/select/select_misses.frag");
    misses.set("hits", hits);
    const LiveMask mask(mask_width, mask_height);
    CHECK(count_live(mask, misses) == 6);
    CHECK(count_live(mask, misses) == 6); // to count changes nothing
}

TEST_CASE("retired pixels are those that the program draws", "[gpu][live_mask]") {
    const auto context = make_context(ContextKind::automatic);
    const Program all("pass/select/select_all.frag");
    const Texture columns = hit_texels(mask_width, mask_height, miss_in_odd_columns);
    const Texture lowest_row = hit_texels(mask_width, mask_height, miss_in_lowest_row);
    Program misses("pass/select/select_misses.frag");
    LiveMask mask(mask_width, mask_height);

    retire(mask, misses.set("hits", columns));
    CHECK(count_live(mask, all) == 12);
    CHECK(count_live(mask, misses) == 0);
    retire(mask, misses); // what is dead stays dead
    CHECK(count_live(mask, all) == 12);
    retire(mask, misses.set("hits", lowest_row)); // half of its six pixels are dead already
    CHECK(count_live(mask, all) == 9);
    retire(mask, all);
    CHECK(count_live(mask, all) == 0);
}

TEST_CASE("dead pixels are not drawn", "[gpu][live_mask][draw]") {
    const auto context = make_context(ContextKind::automatic);
    const Texture columns = hit_texels(mask_width, mask_height, miss_in_odd_columns);
    Program misses("pass/select/select_misses.frag");
    LiveMask mask(mask_width, mask_height);
    retire(mask, misses.set("hits", columns));

    const Texture target(TexelFormat::rgba32f, mask_width, mask_height);
    write_texels(target, std::vector<glm::vec4>(24, glm::vec4(5.0f)));
    const Program ones("pass/light/start_weights.frag");
    draw(ones, {.textures = {target}, .live = &mask});
    const std::vector<glm::vec4> texels = read_floats(target);
    for (int i = 0; i < mask_width * mask_height; ++i) {
        CAPTURE(i);
        const float expected = i % 2 == 1 ? 5.0f : 1.0f;
        CHECK(texels[static_cast<std::size_t>(i)] == glm::vec4(expected));
    }
    draw(ones, {.textures = {target}}); // a pass without a mask draws everywhere again
    CHECK(read_floats(target) == std::vector<glm::vec4>(24, glm::vec4(1.0f)));
}
