#pragma once

#include "basics/statistics.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raysteps {

// One walk on one GPU.
struct CardRate {
    std::string contender;
    double rays = 0.0;
    MeasuredRange million_rays_per_second;
    std::string visits_and_tests; // per ray; empty where they were not counted
};

// What a reader's GPU can do: a file that the playground (docs/playground) saves, as its
// gpu_card.schema.json describes it.
struct GpuCard {
    std::string file;
    std::string renderer;
    std::string timer; // gpu or clock
    std::string scene;
    std::string triangle;
    std::string rounding;   // for people: as the lessons do, or what does not hold
    std::string hard_cases; // how many of the conformance suite are wrong; empty where not asked
    std::vector<CardRate> rates;
};

// All files of the folder whose names end in .json, by name. What cannot be read as a card is told
// in one sentence each. Throws InputError where there is no such folder, or no such file in it.
struct GpuCards {
    std::vector<GpuCard> cards;
    std::vector<std::string> complaints;
};

GpuCards read_gpu_cards(const std::filesystem::path& folder);

// For people: the GPUs, then for each scene and walk what they do, the fastest first.
std::string to_table(const std::vector<GpuCard>& cards);

// Prints the table of the folder's cards. Throws InputError with the complaints, one a line.
void print_gpu_cards(const std::filesystem::path& folder);

} // namespace raysteps
