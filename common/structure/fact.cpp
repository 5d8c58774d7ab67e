#include "basics/text.h"
#include "structure/structure.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace raysteps {

namespace {

// 0.0398 of "s" is 39.8 ms. The scales go down; below the last one stands the last.
struct Scale {
    double size;
    const char* unit;
};

template <std::size_t Count>
std::string scaled(double value, const std::array<Scale, Count>& scales) {
    const auto fitting = std::find_if(scales.begin(), scales.end() - 1,
                                      [&](const Scale& scale) { return value >= scale.size; });
    return readable(value / fitting->size) + " " + fitting->unit;
}

constexpr std::array<Scale, 3> of_time{{{1.0, "s"}, {1e-3, "ms"}, {1e-6, "us"}}};
constexpr std::array<Scale, 4> of_memory{{{1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}, {1.0, "bytes"}}};

} // namespace

std::string readable(const Fact& fact) {
    const std::size_t last = fact.name.rfind('_');
    const std::string unit = last == std::string::npos ? "" : fact.name.substr(last + 1);
    const bool is_time = unit == "seconds";
    const bool is_memory = unit == "bytes";
    const std::string name = spoken(is_time || is_memory ? fact.name.substr(0, last) : fact.name);
    if (is_time) {
        return name + " " + scaled(fact.value, of_time);
    }
    return name + " " + (is_memory ? scaled(fact.value, of_memory) : readable(fact.value));
}

} // namespace raysteps
