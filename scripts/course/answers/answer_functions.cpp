#include "answer_functions.h"

#include "basics/error.h"
#include "basics/statistics.h"
#include "measure/contest.h"
#include "measure/cosine_direction.h"
#include "render/effects/plan.h"
#include "render/rays.h"
#include "scene/scene.h"
#include "structure/kd_tree/kd_split.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace raysteps {

namespace {

using Numbers = std::array<double, 8>;

std::uint32_t bits(double number) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(number));
}

Numbers numbers_of(const Ray& ray) {
    return {ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
            ray.direction.y, ray.direction.z, ray.t_min,    ray.t_max};
}

Ray random_numbers(std::mt19937& generator) {
    std::array<float, 8> numbers{};
    for (float& number : numbers) {
        number = static_cast<float>(1 + generator() % 256) / 64.0f;
    }
    const auto [a, b, c, d, e, f, g, h] = numbers;
    return {{a, b, c}, {d, e, f}, g, h};
}

int number_named(const CourseQuestion& question, const std::string& name, int otherwise) {
    const auto named = question.numbers.find(name);
    return named == question.numbers.end() ? otherwise : named->second;
}

// What a float leaves of the number: 0 where it is one.
std::uint32_t rest_bits(double number) {
    return bits(number - static_cast<double>(static_cast<float>(number)));
}

// A range as numbers, and what floats leave of them.
Found found_of(const MeasuredRange& range) {
    return {bits(range.median),      bits(range.lowest),      bits(range.highest),
            rest_bits(range.median), rest_bits(range.lowest), rest_bits(range.highest)};
}

// Of the first `numbers.rounds` numbers. Where there are more rounds than numbers, the numbers come
// again, a hair aside that no float holds.
Found range_of_rounds(const CourseQuestion& question, const Ray& ray) {
    constexpr double hair = 0x1p-40;
    const Numbers numbers = numbers_of(ray);
    std::vector<double> rounds;
    for (int i = 0; i < question.numbers.at("rounds"); ++i) {
        const auto count = static_cast<int>(numbers.size());
        const int aside = i < count ? 0 : i * 5 % 17 - 8;
        rounds.push_back(numbers[static_cast<std::size_t>(i % count)] + hair * aside);
    }
    return found_of(measured_range(rounds));
}

// Three numbers from `first` on, in their order, as a range.
MeasuredRange range_from(const Ray& ray, std::size_t first) {
    const Numbers numbers = numbers_of(ray);
    std::array<double, 3> three{numbers[first], numbers[first + 1], numbers[first + 2]};
    std::sort(three.begin(), three.end());
    return {.median = three[1], .lowest = three[0], .highest = three[2]};
}

double moved_by_places(double number, double places) {
    const double goal = places < 0.0 ? -std::numeric_limits<double>::infinity()
                                     : std::numeric_limits<double>::infinity();
    for (int left = static_cast<int>(std::abs(places)); left > 0; --left) {
        number = std::nextafter(number, goal);
    }
    return number;
}

// Of two ranges, both ways. With `numbers.places` the last two numbers move the end of the first
// and the start of the second by units in the last place.
Found surely_below(const CourseQuestion& question, const Ray& ray) {
    MeasuredRange first = range_from(ray, 0);
    MeasuredRange second = range_from(ray, 3);
    if (number_named(question, "places", 0) != 0) {
        first.highest = moved_by_places(first.highest, numbers_of(ray)[6]);
        second.lowest = moved_by_places(second.lowest, numbers_of(ray)[7]);
    }
    return {lies_below(first, second) ? 1U : 0U, lies_below(second, first) ? 1U : 0U};
}

// Of `numbers.scenes` pairs of a number of triangles, over `numbers.base`, and a cost, so many
// `numbers.copies` of each; no number where the function refuses them.
Found growth(const CourseQuestion& question, const Ray& ray) {
    const Numbers numbers = numbers_of(ray);
    const auto scenes = static_cast<std::size_t>(number_named(question, "scenes", 4));
    std::vector<GrowthPoint> points;
    for (int copy = 0; copy < number_named(question, "copies", 1); ++copy) {
        for (std::size_t i = 0; i < 2 * scenes; i += 2) {
            points.push_back({number_named(question, "base", 0) + numbers[i], numbers[i + 1]});
        }
    }
    try {
        return {bits(growth_exponent(points))};
    } catch (const InputError&) {
        return {bits(std::numeric_limits<double>::quiet_NaN())};
    }
}

Found bounce(const CourseQuestion& /*question*/, const Ray& ray) {
    const glm::vec3 direction = cosine_direction(glm::normalize(ray.origin), ray.direction);
    return {std::bit_cast<std::uint32_t>(direction.x), std::bit_cast<std::uint32_t>(direction.y),
            std::bit_cast<std::uint32_t>(direction.z), 0};
}

// Point i of a spiral over the sphere of radius 1/2, which a thousand of them cover evenly: each
// has the same area, and turns by the golden angle. Source: Saff and Kuijlaars, "Distributing many
// points on a sphere", 1997.
constexpr int points_on_spiral = 1000;

glm::vec3 point_on_spiral(int i) {
    const double height = 1.0 - (2.0 * i + 1.0) / points_on_spiral;
    const double radius = std::sqrt(1.0 - height * height);
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    return 0.5f * glm::vec3(radius * std::cos(angle), radius * std::sin(angle), height);
}

// The means of the cosine and of its square, over bounces that know nothing of each other.
Found mean_bounce(const CourseQuestion& /*question*/, const Ray& ray) {
    const glm::vec3 normal = glm::normalize(ray.origin);
    double cosines = 0.0;
    double squares = 0.0;
    for (int i = 0; i < points_on_spiral; ++i) {
        const glm::vec3 direction = cosine_direction(normal, point_on_spiral(i));
        const double cosine = static_cast<double>(glm::dot(glm::normalize(direction), normal));
        cosines += cosine;
        squares += cosine * cosine;
    }
    return {bits(cosines / points_on_spiral), bits(squares / points_on_spiral), 0, 0};
}

// Column and row of a ray in a list: its number is the first of the numbers, so many times, and the
// second says how many blocks lie side by side.
Found listed_ray(const CourseQuestion& question, const Ray& ray) {
    const int times = question.numbers.at("times");
    const auto number = static_cast<std::size_t>(ray.origin.x * static_cast<float>(times));
    const int width = 8 * std::max(1, static_cast<int>(ray.origin.y));
    const std::size_t texel = texel_of_listed_ray(number, width);
    const auto columns = static_cast<std::size_t>(width);
    return {static_cast<std::uint32_t>(texel % columns),
            static_cast<std::uint32_t>(texel / columns), 0, 0};
}

// What a contest of so many contenders and rounds calls, one after the other: the contender, from
// 1, and 1 to prepare it, 2 to run it. Behind it, how many rounds the contender of that number has
// kept.
std::vector<Found> calls_of_contest(const CourseQuestion& question, const Ray& ray) {
    const int count = std::clamp(static_cast<int>(ray.origin.x), 1, 4);
    const int rounds = std::clamp(static_cast<int>(ray.origin.y), 1, 5);
    std::vector<Found> calls;
    std::vector<Contender> contenders;
    for (int i = 1; i <= count; ++i) {
        const auto call = [&calls, i](std::uint32_t kind) {
            calls.push_back({static_cast<std::uint32_t>(i), kind, 0, 0});
        };
        contenders.push_back({std::to_string(i), [call] { call(2); }, [call] { call(1); }});
    }
    const std::vector<ContestTimes> times = run_contest(contenders, rounds);
    calls.resize(static_cast<std::size_t>(question.steps));
    for (std::size_t i = 0; i < std::min(calls.size(), times.size()); ++i) {
        calls[i][2] = static_cast<std::uint32_t>(times[i].rounds.size());
    }
    return calls;
}

// A wall, a lamp and perhaps a ball of glass, as the numbers say: which effects they call for, in
// the order of list_effects.
std::vector<Found> effects_of_scene(const CourseQuestion& question, const Ray& ray) {
    const auto choice = [](float number) { return std::clamp(static_cast<int>(number), 0, 3); };
    const auto triangle_at = [](float z) {
        return std::array<glm::vec3, 3>{glm::vec3(-1, -1, z), glm::vec3(1, -1, z),
                                        glm::vec3(0, 1, z)};
    };
    Scene scene;
    const auto add = [&](float z, int material) {
        for (const glm::vec3& corner : triangle_at(z)) {
            scene.corners.push_back(corner);
            scene.normals.emplace_back(0.0f, 0.0f, 1.0f);
            scene.texture_coordinates.emplace_back(0.0f);
        }
        scene.triangle_materials.push_back(material);
    };
    Material wall;
    wall.diffuse = glm::vec3(choice(ray.origin.y) > 0 ? 0.8f : 0.0f);
    Material shiny = wall;
    shiny.specular = glm::vec3(choice(ray.origin.z) > 0 ? 0.5f : 0.0f);
    shiny.shininess = 20.0f;
    shiny.illumination_model = 2;
    Material glass;
    glass.diffuse = glm::vec3(0.5f);
    glass.opacity = 0.0f;
    glass.illumination_model = 6;
    scene.materials = {shiny, glass};
    for (int i = 0; i < choice(ray.direction.x); ++i) {
        add(-static_cast<float>(i), 0);
    }
    if (choice(ray.direction.y) > 0) {
        add(choice(ray.direction.y) == 1 ? 1.0f : 9.0f, 1); // before the eye, or behind it
    }
    if (choice(ray.origin.x) > 0) {
        Light light;
        light.color = glm::vec3(choice(ray.origin.x) > 1 ? 1.0f : 0.0f);
        if (choice(ray.origin.x) == 3) {
            light.across = glm::vec3(1.0f, 0.0f, 0.0f);
            light.along = glm::vec3(0.0f, 0.0f, 1.0f);
        }
        scene.lights.push_back(light);
    }
    std::vector<Found> found(static_cast<std::size_t>(question.steps));
    for (const EffectCall& call : effects_called_for(scene, 1.0, Quality{}.faintest)) {
        const auto place = static_cast<std::size_t>(call.effect);
        if (place < found.size()) {
            found[place][0] = 1;
        }
    }
    return found;
}

// Of two contenders in three rounds each or in `numbers.rounds`, by processor time, or with
// `numbers.clock` by the clock. By the clock the rounds took as long in another order, so that
// nobody takes one for the other.
Found ratio_of_speeds(const CourseQuestion& question, const Ray& ray) {
    const Numbers numbers = numbers_of(ray);
    const auto rounds = static_cast<std::size_t>(number_named(question, "rounds", 3));
    ContestTimes ours{"ours", {}};
    ContestTimes theirs{"theirs", {}};
    for (std::size_t round = 0; round < rounds; ++round) {
        ours.rounds.push_back({.clock = 1.0 + numbers[(round + 1) % 3], .cpu = numbers[round]});
        theirs.rounds.push_back(
            {.clock = 1.0 + numbers[3 + (round + 1) % 3], .cpu = numbers[3 + round]});
    }
    const bool by_clock = number_named(question, "clock", 0) != 0;
    const MeasuredRange ratio = speed_ratio(ours, numbers[6], theirs, numbers[7],
                                            by_clock ? &Seconds::clock : &Seconds::cpu);
    return {bits(ratio.median), bits(ratio.lowest), bits(ratio.highest)};
}

// A box with the lower corner 0, split along x. The first three numbers are its sides, then come a
// quarter of the plane's share of the side along x, how many triangles lie below the plane and
// above it (rounded down), and what a step and a test cost; `empty_bonus` is in hundredths.
Found plane_cost(const CourseQuestion& question, const Ray& ray) {
    const Numbers numbers = numbers_of(ray);
    const Box box{glm::vec3(0.0f), ray.origin};
    const auto plane = static_cast<float>(numbers[3] / 4.0 * numbers[0]);
    const auto below = static_cast<int>(numbers[4]);
    const auto above = static_cast<int>(numbers[5]);
    // The only event within the box is the plane, where a triangle ends that is one of those below,
    // or one starts that is one of those above.
    KdEvents events;
    const auto add = [&](float from, float to, int triangle) {
        events[0].push_back(make_event(from, triangle, KdEventKind::start));
        events[0].push_back(make_event(to, triangle, KdEventKind::end));
    };
    const float before = -1.0f;
    const float behind = box.upper.x + 1.0f;
    for (int i = 0; i < below; ++i) {
        add(before, i == 0 ? plane : before + 0.5f, i);
    }
    for (int i = below; i < below + above; ++i) {
        add(below == 0 && i == 0 ? plane : behind, behind + 1.0f, i);
    }
    std::sort(events[0].begin(), events[0].end(), [](const KdEvent& a, const KdEvent& b) {
        return a.position < b.position || (a.position == b.position && a.code < b.code);
    });
    KdOptions options;
    options.traversal_cost = numbers[6];
    options.intersection_cost = numbers[7];
    options.empty_bonus = question.numbers.at("empty_bonus") / 100.0;
    const KdPlane found = cheapest_plane(events, box, 0.0, options);
    return {bits(found.cost), static_cast<std::uint32_t>(found.lower_count),
            static_cast<std::uint32_t>(found.upper_count), bits(static_cast<double>(plane))};
}

using AskFunction = Found (*)(const CourseQuestion&, const Ray&);

// One number after the other, in the steps of the answer.
using AskList = std::vector<Found> (*)(const CourseQuestion&, const Ray&);

AskList list_of(const std::string& subject) {
    static const std::map<std::string, AskList> lists{{"calls_of_contest", calls_of_contest},
                                                      {"effects_of_scene", effects_of_scene}};
    const auto place = lists.find(subject);
    return place == lists.end() ? nullptr : place->second;
}

AskFunction function_of(const std::string& subject) {
    static const std::map<std::string, AskFunction> functions{{"range_of_rounds", range_of_rounds},
                                                              {"surely_below", surely_below},
                                                              {"growth", growth},
                                                              {"bounce", bounce},
                                                              {"mean_bounce", mean_bounce},
                                                              {"listed_ray", listed_ray},
                                                              {"plane_cost", plane_cost},
                                                              {"speed_ratio", ratio_of_speeds}};
    const auto place = functions.find(subject);
    if (place == functions.end()) {
        throw InputError(
            "no function has the name " + subject +
            ". Take range_of_rounds, surely_below, growth, bounce, mean_bounce, "
            "listed_ray, plane_cost, speed_ratio, calls_of_contest or effects_of_scene.");
    }
    return place->second;
}

} // namespace

Answer answer_by_functions(const CourseQuestion& question) {
    const AskList ask_list = list_of(question.subject);
    const AskFunction ask = ask_list ? nullptr : function_of(question.subject);
    Answer answer{question.rays, {}};
    answer.steps.resize(ask_list ? static_cast<std::size_t>(question.steps) : 1);
    std::mt19937 generator(static_cast<std::uint32_t>(question.seed));
    for (int i = 0; i < question.random_rays; ++i) {
        answer.rays.push_back(random_numbers(generator));
    }
    for (const Ray& ray : answer.rays) {
        if (!ask_list) {
            answer.steps.front().push_back(ask(question, ray));
            continue;
        }
        const std::vector<Found> list = ask_list(question, ray);
        for (std::size_t step = 0; step < list.size(); ++step) {
            answer.steps[step].push_back(list[step]);
        }
    }
    return answer;
}

} // namespace raysteps
