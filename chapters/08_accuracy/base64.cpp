#include "base64.h"

#include <cstdint>

namespace raysteps {

std::string to_base64(std::string_view bytes) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            const std::uint32_t byte =
                i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U;
            three = three << 8U | byte;
        }
        const std::size_t left = bytes.size() - i;
        text += letters[three >> 18U];
        text += letters[three >> 12U & 63U];
        text += left > 1 ? letters[three >> 6U & 63U] : '=';
        text += left > 2 ? letters[three & 63U] : '=';
    }
    return text;
}

} // namespace raysteps
