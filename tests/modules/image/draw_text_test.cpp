#include "image/draw_text.h"

#include "count_ink.h"

#include "catch.h"

#include <rapidcheck.h>

#include <algorithm>

using namespace raysteps;

namespace {

std::string without_spaces(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
}

// Words of letters with single spaces between and around them.
std::string random_words() {
    const rc::Gen<char> letter = rc::gen::element(' ', 'a', 'i', 'W', '.', '1');
    return *rc::gen::container<std::string>(letter);
}

} // namespace

TEST_CASE("a vertical bar is drawn as the one rectangle that it is", "[image]") {
    const Image image = draw_line("|");
    CHECK(image.width == text_width("|"));
    CHECK(image.height == text_line_height);
    const int ink = count_ink(image, {0, image.width, 0, image.height});
    int columns_with_ink = 0;
    for (int column = 0; column < image.width; column++) {
        columns_with_ink += count_ink(image, {column, column + 1, 0, image.height}) > 0 ? 1 : 0;
    }
    CHECK(columns_with_ink == 2); // the font's pixels are 2 x 2
    CHECK(ink % 2 == 0);
    CHECK(ink >= 2 * 14);
}

TEST_CASE("every printable character has ink except the space", "[image]") {
    for (char character = '!'; character <= '~'; character++) {
        CAPTURE(character);
        const Image image = draw_line(std::string(1, character));
        CHECK(count_ink(image, {0, image.width, 0, image.height}) > 0);
    }
    const Image space = draw_line(" ");
    CHECK(count_ink(space, {0, space.width, 0, space.height}) == 0);
}

TEST_CASE("a character beyond ASCII is one question mark", "[image]") {
    CHECK(draw_line("\xc2\xb5s").pixels == draw_line("?s").pixels);
    CHECK(draw_line("\x7f\x01").pixels == draw_line("??").pixels);
}

TEST_CASE("any bytes can be drawn and have the width that is promised", "[image]") {
    REQUIRE(rc::check([] {
        const auto text = *rc::gen::arbitrary<std::string>();
        RC_ASSERT(draw_line(text).width == text_width(text));
        const int width = *rc::gen::inRange(0, 200);
        RC_ASSERT(draw_paragraph(text, width).width == width);
    }));
}

TEST_CASE("text wraps at spaces and keeps its line breaks", "[image]") {
    const int width = text_width("two words");
    CHECK(wrap_text("two words more", width) == std::vector<std::string>{"two words", "more"});
    CHECK(wrap_text("two\nwords", width) == std::vector<std::string>{"two", "words"});
    CHECK(wrap_text("twowordsmore", text_width("twowor")) ==
          std::vector<std::string>{"twowor", "dsmore"});
    CHECK(wrap_text("", width).empty());
}

TEST_CASE("wrapped lines fit and lose no letter", "[image]") {
    REQUIRE(rc::check([] {
        const std::string text = random_words();
        const int width = *rc::gen::inRange(1, 200);
        std::string joined;
        for (const std::string& line : wrap_text(text, width)) {
            RC_ASSERT(line.size() == 1U || text_width(line) <= width);
            joined += line;
        }
        RC_ASSERT(without_spaces(joined) == without_spaces(text));
    }));
}
