#include "gpu_cards.h"

#include "basics/error.h"
#include "program/figures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <tuple>

namespace raysteps {

namespace {

const std::string card_schema = "gpu_card.schema.json";

// A file may come from anybody: what it says is printed without what steers a terminal.
std::string printable(std::string text) {
    std::ranges::replace_if(
        text, [](char letter) { return static_cast<unsigned char>(letter) < ' ' || letter == 127; },
        ' ');
    return text;
}

double number_above(const Numbers& numbers, const std::string& name, double lowest) {
    const double number = numbers.at(name).number();
    if (!std::isfinite(number) || number < lowest) {
        throw InputError(fmt::format("`{}` is {}, which nobody can have measured", name, number));
    }
    return number;
}

std::string rounding_of(const Numbers& rounding) {
    std::string wrong;
    for (const Numbers& one : rounding.at("questions").values()) {
        if (std::get<bool>(one.at("matters").value()) && one.at("wrong").number() > 0.0) {
            wrong += (wrong.empty() ? "not always: " : " ") + printable(one.at("question").text());
        }
    }
    return wrong.empty() ? "as the lessons do" : wrong;
}

// Of the conformance suite, where the card has it.
std::string hard_cases_of(const Numbers& figures) {
    const Numbers* suite = figures.find("conformance");
    if (suite == nullptr) {
        return "";
    }
    return fmt::format("; hard cases {:.0f} of {:.0f} wrong", number_above(*suite, "wrong", 0.0),
                       number_above(*suite, "tried", 1.0));
}

CardRate rate_of(const Numbers& walk) {
    CardRate rate{printable(walk.at("contender").text()),
                  number_above(walk, "rays", 1.0),
                  {number_above(walk, "million_rays_per_second", 0.0),
                   number_above(walk, "lowest", 0.0), number_above(walk, "highest", 0.0)},
                  {}};
    if (walk.find("visits_per_ray") != nullptr) {
        rate.visits_and_tests =
            fmt::format("{:.2f} {:.2f}", number_above(walk, "visits_per_ray", 0.0),
                        number_above(walk, "tests_per_ray", 0.0));
    }
    return rate;
}

GpuCard card_of(const std::filesystem::path& path) {
    const Numbers figures = read_figures(path, card_schema);
    GpuCard card{printable(path.filename().string()),
                 printable(figures.at("head").at("renderer").text()),
                 figures.at("timer").text(),
                 printable(figures.at("scene").text()),
                 printable(figures.at("triangle").text()),
                 rounding_of(figures.at("rounding")),
                 hard_cases_of(figures),
                 {}};
    if (card.timer != "gpu" && card.timer != "clock") {
        throw InputError("`timer` is neither gpu nor clock");
    }
    for (const Numbers& walk : figures.at("walks").values()) {
        card.rates.push_back(rate_of(walk));
    }
    return card;
}

// The path first, and once.
std::string complaint_of(const std::filesystem::path& path, const std::string& why) {
    return why.find(path.string()) == 0
               ? why
               : path.string() + ": " + why + (why.back() == '.' ? "" : ". Save the card again.");
}

std::string table_of_scene(const std::vector<GpuCard>& cards, const std::string& scene) {
    struct Row {
        const GpuCard* card;
        const CardRate* rate;
    };
    std::vector<Row> rows;
    std::size_t card_width = 4;
    std::size_t walk_width = 9;
    for (const GpuCard& card : cards) {
        for (const CardRate& rate : card.rates) {
            if (card.scene == scene) {
                rows.push_back({&card, &rate});
                card_width = std::max(card_width, card.file.size());
                walk_width = std::max(walk_width, rate.contender.size());
            }
        }
    }
    std::ranges::stable_sort(rows, [](const Row& a, const Row& b) {
        return std::tuple(a.rate->contender, -a.rate->million_rays_per_second.median) <
               std::tuple(b.rate->contender, -b.rate->million_rays_per_second.median);
    });
    std::string table = fmt::format("\n{}\n{:{}}  {:{}}  {:>26}  {:5}  {:>7}  visits and tests\n",
                                    scene, "contender", walk_width, "card", card_width,
                                    "million rays/s (range)", "by", "rays");
    for (const auto& [card, rate] : rows) {
        const MeasuredRange& range = rate->million_rays_per_second;
        const std::string rates =
            fmt::format("{:.2f} ({:.2f}-{:.2f})", range.median, range.lowest, range.highest);
        table += fmt::format("{:{}}  {:{}}  {:>26}  {:5}  {:>7.0f}  {}\n", rate->contender,
                             walk_width, card->file, card_width, rates, card->timer, rate->rays,
                             rate->visits_and_tests);
    }
    return table;
}

} // namespace

GpuCards read_gpu_cards(const std::filesystem::path& folder) {
    std::error_code failed;
    std::set<std::filesystem::path> files;
    for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (entry->path().extension() == ".json") {
            files.insert(entry->path());
        }
    }
    if (failed) {
        throw InputError("--gpu-cards " + folder.string() + ": the folder cannot be read (" +
                         failed.message() + "). Name the one with the cards.");
    }
    if (files.empty()) {
        throw InputError("--gpu-cards " + folder.string() +
                         ": there is no file *.json in it. Save some in the playground.");
    }
    GpuCards found;
    for (const std::filesystem::path& path : files) {
        try {
            found.cards.push_back(card_of(path));
        } catch (const Error& error) {
            found.complaints.push_back(complaint_of(path, error.what()));
        } catch (const std::bad_variant_access&) {
            found.complaints.push_back(
                complaint_of(path, "`matters` is neither true nor false. Save the card again."));
        }
    }
    return found;
}

std::string to_table(const std::vector<GpuCard>& cards) {
    std::string table;
    std::set<std::string> scenes;
    std::size_t width = 4;
    for (const GpuCard& card : cards) {
        scenes.insert(card.scene);
        width = std::max(width, card.file.size());
    }
    for (const GpuCard& card : cards) {
        table += fmt::format("{:{}}  {}; triangle test {}; rounds {}{}\n", card.file, width,
                             card.renderer, card.triangle, card.rounding, card.hard_cases);
    }
    for (const std::string& scene : scenes) {
        table += table_of_scene(cards, scene);
    }
    return table;
}

void print_gpu_cards(const std::filesystem::path& folder) {
    const GpuCards found = read_gpu_cards(folder);
    std::cout << to_table(found.cards) << std::flush;
    std::string complaints;
    for (const std::string& complaint : found.complaints) {
        complaints += (complaints.empty() ? "" : "\n") + complaint;
    }
    if (!complaints.empty()) {
        throw InputError(complaints);
    }
}

} // namespace raysteps
