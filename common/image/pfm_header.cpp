#include "image/pfm_header.h"

#include "error/error.h"
#include "image/check_image.h"

#include <charconv>
#include <optional>

namespace raysteps {

namespace {

// No line of a valid header is longer.
constexpr std::size_t most_line_length = 64;

std::string_view read_line(const std::string& name, std::string_view bytes, int number) {
    const std::size_t end = bytes.substr(0, most_line_length).find('\n');
    if (end == std::string_view::npos) {
        throw InputError(name + ":" + std::to_string(number) +
                         ": the header of a PFM file has three short lines, but this one does not "
                         "end. Save it again as color PFM.");
    }
    return bytes.substr(0, end);
}

template <class Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, number);
    if (result.ec != std::errc() || result.ptr != end) {
        return std::nullopt;
    }
    return number;
}

struct Size {
    int width = 0;
    int height = 0;
};

std::optional<Size> parse_size(std::string_view line) {
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<int> width = parse_number<int>(line.substr(0, space));
    const std::optional<int> height = parse_number<int>(line.substr(space + 1));
    if (!width || !height) {
        return std::nullopt;
    }
    return Size{*width, *height};
}

} // namespace

PfmHeader parse_pfm_header(const std::string& name, std::string_view bytes) {
    const std::string_view kind = read_line(name, bytes, 1);
    if (kind != "PF") {
        throw InputError(name + ":1: a color PFM file begins with the line PF, but this one does "
                                "not. Save it again as color PFM.");
    }
    PfmHeader header;
    header.length = kind.size() + 1;

    const std::string_view size_line = read_line(name, bytes.substr(header.length), 2);
    const std::optional<Size> size = parse_size(size_line);
    if (!size) {
        throw InputError(name + ":2: this line must be the width and the height, two whole numbers "
                                "and a space between them. Save it again as color PFM.");
    }
    check_size(name + ":2", size->width, size->height);
    header.width = size->width;
    header.height = size->height;
    header.length += size_line.size() + 1;

    const std::string_view scale_line = read_line(name, bytes.substr(header.length), 3);
    const double scale = parse_number<double>(scale_line).value_or(0.0);
    if (scale != 1.0 && scale != -1.0) {
        throw InputError(name + ":3: this line must be the scale, 1.0 for big endian or -1.0 for "
                                "little endian. Save it again with one of them.");
    }
    header.byte_order = scale < 0.0 ? std::endian::little : std::endian::big;
    header.length += scale_line.size() + 1;
    return header;
}

} // namespace raysteps
