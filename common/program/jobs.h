#pragma once

#include "basics/numbers.h"
#include "program/options.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// A word as a shell takes it for one: in quotes where it holds more than letters, digits and a few
// signs.
std::string shell_word(const std::string& word);

// A part of a run that does not depend on the others: its name, and the options that ask for it
// alone.
struct RunPart {
    std::string name;
    std::vector<std::string> options;
};

// What the command line says of parts. docs/figures.md has how they are run.
struct JobOptions {
    std::filesystem::path file{};    // to write a command for each part to; empty: run
    std::filesystem::path results{}; // the folder of what the parts write
    std::filesystem::path merge{};   // that folder, to join what is in it; empty: run
};

// --jobs-file --results --merge
void add_job_options(Options& options, JobOptions& jobs);

// The words of a command line without these options, each of which has a value.
std::vector<std::string> words_without(int argc, char** argv,
                                       const std::vector<std::string>& options);

// Writes the file of commands, a line each: this program with the words and with the job's own
// options, its figures to RESULTS/NAME.json and its other files to the folder RESULTS/NAME. The
// folder also gets jobs.json, by which read_parts knows what there is to come.
void write_jobs(const JobOptions& options, const std::vector<std::string>& words,
                std::span<const RunPart> jobs);

// What parts have left behind.
struct JobParts {
    std::vector<std::string> names; // of those that are there, in the order of the jobs
    std::vector<Numbers> figures;
    std::vector<std::string> missing;
};

// Prints the command of each part that is missing. Throws InputError where the folder has no jobs
// or no part, or where the parts are of several commits.
JobParts read_parts(const std::filesystem::path& folder, const std::string& schema);

// The head of the first part, with the scenes and the processors of all.
Numbers head_of(const JobParts& parts);

// A member that must be the same in all parts, as the first has it. Throws InputError where it is
// not.
const Numbers& common_member(const JobParts& parts, const std::string& name);

// Throws Error with exit code 1 where parts are missing, with their names.
void check_complete(const JobParts& parts);

} // namespace raysteps
