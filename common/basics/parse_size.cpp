#include "parse/parse_size.h"

#include "error/error.h"
#include "parse/words.h"

namespace raysteps {

namespace {

constexpr int largest_side = 16384;

} // namespace

PictureSize parse_size(const std::string& text) {
    const std::vector<std::string> words = split_words(text, 'x');
    const auto width = parse_number<int>(words.front());
    const auto height = parse_number<int>(words.back());
    const auto fits = [](int side) { return side >= 1 && side <= largest_side; };
    if (words.size() > 2 || !width || !height || !fits(*width) || !fits(*height)) {
        throw InputError("--size " + text +
                         ": a size is WIDTHxHEIGHT, as in 640x480, each from 1 to " +
                         std::to_string(largest_side) + ".");
    }
    return {*width, *height};
}

} // namespace raysteps
