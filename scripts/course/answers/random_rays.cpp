#include "random_rays.h"

#include "basics/error.h"
#include "basics/random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raysteps {

namespace {

// Beyond it, a random ray starts nowhere near the box.
constexpr float farthest_start = 1.5f;

constexpr float farthest = std::numeric_limits<float>::max();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

// A ray of the first family, made into one of another. Its target is at t = 1.
using Family = Ray (*)(Ray ray, RandomNumbers& numbers);

Ray bounded(Ray ray, RandomNumbers& /*numbers*/) {
    return ray;
}

// With a first and a last t on both sides of its origin, and of each other.
Ray with_ends(Ray ray, RandomNumbers& numbers) {
    ray.t_min = 3.0f * numbers.unit() - 1.5f;
    ray.t_max = 4.0f * numbers.unit() - 1.5f;
    return ray;
}

// The box lies behind the origin, where t is negative.
Ray behind(Ray ray, RandomNumbers& numbers) {
    ray.direction = -ray.direction;
    ray.t_min = -4.0f;
    ray.t_max = numbers.below(2) == 0 ? 0.0f : farthest;
    return ray;
}

// Along one axis or two; the others have the direction 0.
Ray along_axes(Ray ray, RandomNumbers& numbers) {
    const glm::vec3 target = ray.origin + ray.direction;
    const int axis = numbers.below(3);
    ray.direction[axis] = 0.0f;
    ray.direction[(axis + 1) % 3] *= static_cast<float>(numbers.below(2));
    ray.origin = target - ray.direction;
    return ray;
}

Ray inside(Ray ray, RandomNumbers& numbers) {
    ray.origin += ray.direction;
    ray.direction = numbers.in_cube();
    return ray;
}

// Of small whole numbers, wherever the box is: what comes of them is exact, and often equal, zero
// or on a plane. Every other one has ends.
Ray whole(Ray ray, RandomNumbers& numbers) {
    for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = static_cast<float>(numbers.below(7) - 1);
        ray.direction[axis] = static_cast<float>(numbers.below(5) - 2);
    }
    if (numbers.below(2) == 0) {
        ray.t_min = static_cast<float>(numbers.below(5) - 2);
        ray.t_max = ray.t_min + static_cast<float>(numbers.below(5) - 1);
    }
    return ray;
}

// t counts lengths of the direction: here, of very short ones and of very long ones.
Ray slow(Ray ray, RandomNumbers& /*numbers*/) {
    ray.direction *= 0x1p-100f;
    return ray;
}

Ray fast(Ray ray, RandomNumbers& /*numbers*/) {
    ray.direction *= 0x1p100f;
    return ray;
}

// So slow, and along one axis, that the t of a plane some way off is infinite.
Ray slowest(Ray ray, RandomNumbers& numbers) {
    const int axis = numbers.below(3);
    const float sign = numbers.below(2) == 0 ? 1.0f : -1.0f;
    ray.origin += ray.direction;
    ray.direction = glm::vec3(0.0f);
    ray.direction[axis] = sign * std::numeric_limits<float>::min() * (1.0f + numbers.unit());
    return ray;
}

// From so far away that rounding moves a point of the ray.
Ray far(Ray ray, RandomNumbers& /*numbers*/) {
    const glm::vec3 target = ray.origin + ray.direction;
    ray.origin = target - 0x1p17f * ray.direction;
    ray.direction = target - ray.origin;
    return ray;
}

float nearby(float number, RandomNumbers& numbers, int most_steps) {
    const float goal = numbers.below(2) == 0 ? infinite : -infinite;
    for (int steps = numbers.below(most_steps + 1); steps > 0; --steps) {
        number = std::nextafter(number, goal);
    }
    return number;
}

// Eight numbers of any size that are equal, but for so many floats up or down.
Ray equal_but_for(Ray ray, RandomNumbers& numbers, int steps) {
    const float sign = numbers.below(2) == 0 ? 1.0f : -1.0f;
    const float number = sign * std::ldexp(0.5f + 0.5f * numbers.unit(), numbers.below(41) - 20);
    for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = nearby(number, numbers, steps);
        ray.direction[axis] = nearby(number, numbers, steps);
    }
    ray.t_min = nearby(number, numbers, steps);
    ray.t_max = nearby(number, numbers, steps);
    return ray;
}

// A few roundings.
Ray nearly_equal(Ray ray, RandomNumbers& numbers) {
    return equal_but_for(ray, numbers, 2);
}

// As far as the room of a box test reaches, and a little farther.
Ray some_floats_apart(Ray ray, RandomNumbers& numbers) {
    return equal_but_for(ray, numbers, 6);
}

// Large numbers beside small ones.
Ray uneven(Ray ray, RandomNumbers& numbers) {
    for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = std::ldexp(ray.origin[axis], numbers.below(41) - 20);
        ray.direction[axis] = std::ldexp(ray.direction[axis], numbers.below(41) - 20);
    }
    return ray;
}

// One number of its origin or its direction is none, or is infinite.
Ray not_numbers(Ray ray, RandomNumbers& numbers) {
    const std::array<float, 3> ill{not_a_number, infinite, -infinite};
    const float number = ill[static_cast<std::size_t>(numbers.below(3))];
    const int place = numbers.below(6);
    (place < 3 ? ray.origin[place] : ray.direction[place - 3]) = number;
    return ray;
}

Family family_named(const std::string& name) {
    static const std::map<std::string, Family> families{{"bounded", bounded},
                                                        {"ends", with_ends},
                                                        {"behind", behind},
                                                        {"along", along_axes},
                                                        {"inside", inside},
                                                        {"whole", whole},
                                                        {"slow", slow},
                                                        {"fast", fast},
                                                        {"slowest", slowest},
                                                        {"far", far},
                                                        {"nearly_equal", nearly_equal},
                                                        {"some_floats_apart", some_floats_apart},
                                                        {"uneven", uneven},
                                                        {"not_numbers", not_numbers}};
    const auto place = families.find(name);
    if (place == families.end()) {
        std::string known;
        for (const auto& [word, family] : families) {
            known += (known.empty() ? "" : ", ") + word;
        }
        throw InputError("no family of rays has the name " + name + ". Take one of " + known + ".");
    }
    return place->second;
}

} // namespace

std::vector<Ray> random_rays(const CourseQuestion& question, const Box& box) {
    const glm::vec3 size = box.upper - box.lower;
    const float around = farthest_start * std::max({size.x, size.y, size.z});
    RandomNumbers numbers(question.seed);
    std::vector<Ray> rays;
    for (int i = 0; i < question.random_rays; ++i) {
        const auto family = static_cast<std::size_t>(i) % question.families.size();
        const glm::vec3 target = box.lower + (0.5f * numbers.in_cube() + 0.5f) * size;
        const glm::vec3 origin = target + around * numbers.in_cube();
        rays.push_back(family_named(question.families[family])(
            {origin, target - origin, 0.0f, farthest}, numbers));
    }
    return rays;
}

} // namespace raysteps
