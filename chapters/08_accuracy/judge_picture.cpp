#include "judge_picture.h"

#include "similarity.h"
#include "image/color.h"
#include "image/difference.h"

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

constexpr float steps_of_srgb = 255.0f;
constexpr glm::vec3 mark{0.9f, 0.02f, 0.02f};

float steps_between(const glm::vec3& a, const glm::vec3& b) {
    float most = 0.0f;
    for (int c = 0; c < 3; ++c) {
        const float p = srgb_from_linear(std::clamp(a[c], 0.0f, 1.0f));
        const float q = srgb_from_linear(std::clamp(b[c], 0.0f, 1.0f));
        most = std::max(most, steps_of_srgb * std::abs(p - q));
    }
    return most;
}

} // namespace

Findings judge_picture(const Image& picture, const Image& truth) {
    Fault visible{"visible pixels", 0, picture.pixels.size()};
    std::vector<float> errors;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        errors.push_back(steps_between(picture.pixels[i], truth.pixels[i]));
        visible.count += errors.back() > 1.0f ? 1 : 0;
    }
    return {{visible},
            summarize(errors),
            {{"RMSE", difference(picture, truth, 0.0f).rmse},
             {"similarity", structural_similarity(picture, truth)}}};
}

Image mark_differences(const Image& picture, const Image& truth) {
    Image marked = picture;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::vec3& color = picture.pixels[i];
        const float grey = 0.3f + 0.5f * (color.x + color.y + color.z) / 3.0f;
        marked.pixels[i] = steps_between(color, truth.pixels[i]) > 1.0f ? mark : glm::vec3(grey);
    }
    return marked;
}

} // namespace raysteps
