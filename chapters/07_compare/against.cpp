#include "against.h"

#include "basics/error.h"
#include "gpu/context.h"
#include "measure/scene_costs.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

namespace {

constexpr double most_by_chance = 0.05;

std::string name_of_scene(const std::string& given) {
    const std::filesystem::path path(given);
    return path.extension() == ".obj" || path.extension() == ".toml" ? path.stem().string() : given;
}

// The one of a list whose member has that text; null where there is none.
const Numbers* find_by(const Numbers& list, const std::string& member, const std::string& text) {
    const auto found = std::ranges::find_if(
        list.values(), [&](const Numbers& one) { return one.at(member).text() == text; });
    return found == list.values().end() ? nullptr : &*found;
}

[[noreturn]] void refuse(const EarlierRun& earlier, const std::string& why) {
    throw InputError("--against " + earlier.path.string() + ": " + why);
}

int rounds_of(const Numbers& figures) {
    return static_cast<int>(figures.at("rounds").number());
}

// "AMD EPYC 7B13, 2 cores, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6"
std::string machine_of(const Numbers& figures) {
    const Numbers& head = figures.at("head");
    return fmt::format("{}, {} cores, {}, {}", head.at("cpu").text(), head.at("cores").number(),
                       head.at("renderer").text(), head.at("opengl").text());
}

MeasuredRange range_of(const Numbers& walk, Yardstick yardstick) {
    switch (yardstick) {
    case Yardstick::embree: {
        const Numbers& range = walk.at("to_embree");
        return {range.at("median").number(), range.at("lowest").number(),
                range.at("highest").number()};
    }
    case Yardstick::processor_time:
        return {walk.at("million_rays_per_cpu_second").number(),
                walk.at("lowest_by_cpu_time").number(), walk.at("highest_by_cpu_time").number()};
    case Yardstick::clock:
        break;
    }
    return {walk.at("million_rays_per_second").number(), walk.at("lowest").number(),
            walk.at("highest").number()};
}

std::string to_words(Yardstick yardstick) {
    switch (yardstick) {
    case Yardstick::embree:
        return "by rates over that of Embree's rtcIntersect1 in the same rounds";
    case Yardstick::processor_time:
        return "by processor time";
    case Yardstick::clock:
        break;
    }
    return "by the clock";
}

bool is_slower(const ChangedRate& rate) {
    return rate.same_rays && is_faster(rate.then, rate.now);
}

std::string verdict_of(const ChangedRate& rate, bool enough_rounds) {
    const std::string how = enough_rounds ? " beyond doubt" : " in every round";
    if (!rate.same_rays) {
        return "not compared: other rays";
    }
    if (is_slower(rate)) {
        return "slower" + how;
    }
    return is_faster(rate.now, rate.then) ? "faster" + how : "ranges overlap";
}

std::string table_of(std::span<const ChangedRate> rates, bool enough_rounds) {
    std::size_t width = 9;
    for (const ChangedRate& rate : rates) {
        width = std::max(width, rate.contender.size());
    }
    std::string table =
        fmt::format("{:16} {:10} {:{}}  now/then (range)\n", "scene", "rays", "contender", width);
    for (const ChangedRate& rate : rates) {
        table += fmt::format("{:16} {:10} {:{}}  {:.2f} ({:.2f} to {:.2f})  {}\n", rate.scene,
                             rate.kind, rate.contender, width, rate.now.median / rate.then.median,
                             rate.now.lowest / rate.then.highest,
                             rate.now.highest / rate.then.lowest, verdict_of(rate, enough_rounds));
    }
    return table;
}

// Walks of the same name may be built with other options.
std::string other_builders(const Numbers& then, const Numbers& now) {
    std::string lines;
    for (const auto& [name, options] : now.at("head").at("builders").members()) {
        const Numbers* const known = then.at("head").at("builders").find(name);
        if (known != nullptr && known->to_json() != options.to_json()) {
            lines += name + " is not built with the same options as then.\n";
        }
    }
    return lines;
}

} // namespace

EarlierRun read_earlier_run(const std::filesystem::path& path) {
    const EarlierRun run{path, read_figures(path, compare_schema)};
    try { // whether all is there that will be read
        const Numbers& figures = run.figures;
        figures.at("width").number();
        figures.at("height").number();
        figures.at("triangle").text();
        figures.at("embree").text();
        figures.at("embree_mode").text();
        figures.at("head").at("commit").text();
        figures.at("head").at("date").text();
        figures.at("head").at("builders").members();
        rounds_of(figures);
        machine_of(figures);
        for (const Numbers& scene : figures.at("head").at("scenes").values()) {
            scene.at("hash").text();
            scene.at("camera").text();
        }
        changed_rates(figures, figures, Yardstick::clock);
        changed_rates(figures, figures, Yardstick::processor_time);
    } catch (const InputError& error) {
        refuse(run, error.what());
    }
    return run;
}

void check_request(const EarlierRun& earlier, const PictureSize& size, const std::string& triangle,
                   std::span<const std::string> scenes) {
    const double width = earlier.figures.at("width").number();
    const double height = earlier.figures.at("height").number();
    if (width != size.width || height != size.height) {
        refuse(earlier, fmt::format("it has the rays of {}x{} pixels, not of {}x{}. Add --size "
                                    "{}x{}.",
                                    width, height, size.width, size.height, width, height));
    }
    const std::string& own_triangle = earlier.figures.at("triangle").text();
    if (own_triangle != triangle) {
        refuse(earlier, "it was measured with --triangle " + own_triangle + ", not with " +
                            triangle + ". Take the same.");
    }
    for (const std::string& scene : scenes) {
        if (find_by(earlier.figures.at("scenes"), "scene", name_of_scene(scene)) == nullptr) {
            std::string known;
            for (const Numbers& one : earlier.figures.at("scenes").values()) {
                known += (known.empty() ? "" : ", ") + one.at("scene").text();
            }
            refuse(earlier, "it has no scene " + name_of_scene(scene) + ", only " + known +
                                ". Choose among them by --scenes and --growth.");
        }
    }
}

void check_scene(const EarlierRun& earlier, const SceneRecord& scene) {
    const Numbers* const known =
        find_by(earlier.figures.at("head").at("scenes"), "scene", scene.scene);
    if (known == nullptr) {
        refuse(earlier, "it has no scene " + scene.scene + ". Leave it out.");
    }
    if (known->at("hash").text() != scene.hash) {
        refuse(earlier, fmt::format("its scene {} is another one (hash {} there, {} here). Measure "
                                    "the same scene.",
                                    scene.scene, known->at("hash").text(), scene.hash));
    }
    if (known->at("camera").text() != scene.camera) {
        refuse(earlier, fmt::format("its scene {} is seen by another camera. Add --camera {}.",
                                    scene.scene, known->at("camera").text()));
    }
}

Yardstick choose_yardstick(const EarlierRun& earlier, const Numbers& now) {
    const Numbers& then = earlier.figures;
    const std::string& embree = now.at("embree").text();
    if (!embree.empty() && then.at("embree").text() == embree &&
        then.at("embree_mode").text() == now.at("embree_mode").text()) {
        return Yardstick::embree;
    }
    if (machine_of(then) != machine_of(now)) {
        refuse(earlier, "it was measured on another machine (" + machine_of(then) + " there, " +
                            machine_of(now) +
                            " here), and Embree did not take part in both runs, in the same "
                            "version and mode. Measure again with --embree robust.");
    }
    return runs_on_processor(now.at("head").at("renderer").text()) ? Yardstick::processor_time
                                                                   : Yardstick::clock;
}

std::vector<ChangedRate> changed_rates(const Numbers& then, const Numbers& now,
                                       Yardstick yardstick) {
    std::vector<ChangedRate> rates;
    for (const Numbers& scene : now.at("scenes").values()) {
        const std::string& name = scene.at("scene").text();
        const Numbers* const scene_then = find_by(then.at("scenes"), "scene", name);
        if (scene_then == nullptr) {
            continue;
        }
        for (const Numbers& kind : scene.at("kinds").values()) {
            const std::string& kind_name = kind.at("kind").text();
            const Numbers* const kind_then = find_by(scene_then->at("kinds"), "kind", kind_name);
            for (const Numbers& walk : kind.at("walks").values()) {
                const std::string& contender = walk.at("contender").text();
                const Numbers* const walk_then =
                    kind_then == nullptr ? nullptr
                                         : find_by(kind_then->at("walks"), "contender", contender);
                if (walk_then != nullptr && !is_embree(contender)) {
                    rates.push_back({name, kind_name, contender, range_of(*walk_then, yardstick),
                                     range_of(walk, yardstick),
                                     walk_then->at("rays").number() == walk.at("rays").number()});
                }
            }
        }
    }
    return rates;
}

double slower_by_chance(std::size_t pairs, int rounds_then, int rounds_now) {
    double orders = 1.0; // C(then + now, now)
    for (int i = 1; i <= rounds_now; ++i) {
        orders *= static_cast<double>(rounds_then + i) / i;
    }
    return static_cast<double>(pairs) / orders;
}

AgainstReport report_against(const EarlierRun& earlier, const Numbers& now) {
    const Numbers& then = earlier.figures;
    const Yardstick yardstick = choose_yardstick(earlier, now);
    const std::vector<ChangedRate> rates = changed_rates(then, now, yardstick);
    const bool same_machine = machine_of(then) == machine_of(now);
    const double by_chance = slower_by_chance(rates.size(), rounds_of(then), rounds_of(now));
    const bool enough_rounds = by_chance < most_by_chance;
    AgainstReport report{.text =
                             fmt::format("Against {} (commit {}, {}), {}\n", earlier.path.string(),
                                         then.at("head").at("commit").text(),
                                         then.at("head").at("date").text(), to_words(yardstick)),
                         .rates = rates.size()};
    report.text += table_of(rates, enough_rounds) + other_builders(then, now);
    if (!same_machine) {
        report.text += "That was another machine: " + machine_of(then) +
                       ". This one: " + machine_of(now) +
                       ". Between two machines the ratios decide nothing.\n";
    }
    if (!enough_rounds) {
        report.text += fmt::format("Chance alone would show {:.2g} of these {} rows slower in "
                                   "every round: take more --rounds in both runs to be beyond "
                                   "doubt.\n",
                                   by_chance, rates.size());
    }
    if (same_machine && enough_rounds) {
        report.slower = static_cast<std::size_t>(std::ranges::count_if(rates, is_slower));
    }
    return report;
}

} // namespace raysteps
