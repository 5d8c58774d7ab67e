#include "image/heat_map.h"

#include "error/error.h"
#include "image/check_image.h"
#include "image/color_map.h"
#include "image/compose.h"
#include "image/draw_legend.h"

#include <algorithm>

namespace raysteps {

Image heat_map(std::span<const float> values, int width, int height, const HeatMapRange& range,
               const std::string& title) {
    check_size("heat map \"" + title + "\"", width, height);
    check_range(range);
    Image picture(width, height);
    if (values.size() != picture.pixels.size()) {
        throw InputError("heat map \"" + title + "\": got " + std::to_string(values.size()) +
                         " values for " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels. Give one value for each pixel.");
    }
    std::transform(values.begin(), values.end(), picture.pixels.begin(),
                   [&range](float value) { return color_map(fraction_of_range(value, range)); });
    return stack(picture, draw_legend(range, title, legend_note(values, range), width));
}

} // namespace raysteps
