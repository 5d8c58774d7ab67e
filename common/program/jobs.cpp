#include "program/jobs.h"

#include "basics/error.h"
#include "basics/file.h"
#include "program/figures.h"
#include "program/output.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <string_view>

namespace raysteps {

namespace {

constexpr std::uintmax_t most_bytes_of_jobs = 16U << 20U;
constexpr const char* jobs_name = "jobs.json";

// A name of a scene may be a path.
std::string file_name_of(std::string name) {
    std::ranges::replace_if(
        name,
        [](char letter) {
            return std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '.' &&
                   letter != '-';
        },
        '_');
    return name;
}

std::string command_of(const std::vector<std::string>& words, const RunPart& job,
                       const std::filesystem::path& results) {
    std::string line = "cd " + shell_word(std::filesystem::current_path().string()) + " && " +
                       shell_word(std::filesystem::read_symlink("/proc/self/exe").string());
    std::vector<std::string> all = words;
    all.insert(all.end(), job.options.begin(), job.options.end());
    const std::string place = (results / file_name_of(job.name)).string();
    all.insert(all.end(), {"--out", place, "--json", place + ".json"});
    for (const std::string& word : all) {
        line += " " + shell_word(word);
    }
    return line;
}

} // namespace

std::string shell_word(const std::string& word) {
    const auto is_plain = [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
               std::string_view("_-./:=,+").find(letter) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) {
        return word;
    }
    std::string text = "'";
    for (const char letter : word) {
        text += letter == '\'' ? "'\\''" : std::string(1, letter);
    }
    return text + "'";
}

void add_job_options(Options& options, JobOptions& jobs) {
    jobs.results = std::filesystem::path("out") / options.program() / "parts";
    options.output_file("--jobs-file", jobs.file,
                        "write a command for each independent part to this file, and run nothing");
    options.output_folder("--results", jobs.results,
                          "the folder into which the commands of --jobs-file write");
    options.value("--merge", "", "join what the parts have written into this folder",
                  [&jobs](const std::string& text) { jobs.merge = text; });
    options.excludes("--merge", {"--jobs-file"});
}

std::vector<std::string> words_without(int argc, char** argv,
                                       const std::vector<std::string>& options) {
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const std::string name = word.substr(0, word.find('='));
        if (std::ranges::find(options, name) == options.end()) {
            words.push_back(word);
        } else if (name == word) {
            ++i; // its value
        }
    }
    return words;
}

void write_jobs(const JobOptions& options, const std::vector<std::string>& words,
                std::span<const RunPart> jobs) {
    const std::filesystem::path results = std::filesystem::absolute(options.results);
    Numbers list = empty_list();
    std::string lines;
    for (const RunPart& job : jobs) {
        const std::string line = command_of(words, job, results);
        lines += line + "\n";
        list.push_back(
            {{"part", job.name}, {"file", file_name_of(job.name) + ".json"}, {"command", line}});
    }
    write_text(results / jobs_name, Numbers{{"jobs", list}}.to_json() + "\n");
    write_text(options.file, lines);
    std::cout << jobs.size() << " commands. When they have run, join their results with --merge "
              << options.results.string() << "\n";
}

JobParts read_parts(const std::filesystem::path& folder, const std::string& schema) {
    const std::filesystem::path list = folder / jobs_name;
    const Numbers jobs = parse_json(read_file(list, most_bytes_of_jobs), list);
    JobParts parts;
    for (const Numbers& job : jobs.at("jobs").values()) {
        const std::string& name = job.at("part").text();
        const std::filesystem::path path = folder / job.at("file").text();
        if (!std::filesystem::exists(path)) {
            std::cout << "missing   " << name << ": " << job.at("command").text() << "\n";
            parts.missing.push_back(name);
            continue;
        }
        parts.names.push_back(name);
        parts.figures.push_back(read_figures(path, schema));
        const std::string& commit = parts.figures.back().at("head").at("commit").text();
        if (commit != parts.figures.front().at("head").at("commit").text()) {
            throw InputError(path.string() + ": this part is of commit " + commit +
                             ", and the first is of another. Run all of them again with one "
                             "program.");
        }
    }
    if (parts.figures.empty()) {
        throw InputError("--merge " + folder.string() +
                         ": no part has left figures there. Run the commands of --jobs-file.");
    }
    return parts;
}

Numbers head_of(const JobParts& parts) {
    Numbers head = parts.figures.front().at("head");
    Numbers scenes = empty_list();
    std::vector<std::string> processors;
    for (const Numbers& figures : parts.figures) {
        for (const Numbers& scene : figures.at("head").at("scenes").values()) {
            const auto same = [&](const Numbers& known) {
                return known.to_json() == scene.to_json();
            };
            if (std::ranges::none_of(scenes.values(), same)) {
                scenes.push_back(scene);
            }
        }
        const std::string& processor = figures.at("head").at("cpu").text();
        if (std::ranges::find(processors, processor) == processors.end()) {
            processors.push_back(processor);
        }
    }
    std::string all;
    for (const std::string& processor : processors) {
        all += (all.empty() ? "" : "; ") + processor;
    }
    head["scenes"] = scenes;
    head["cpu"] = all;
    return head;
}

const Numbers& common_member(const JobParts& parts, const std::string& name) {
    const Numbers& first = parts.figures.front().at(name);
    for (std::size_t i = 1; i < parts.figures.size(); ++i) {
        if (parts.figures[i].at(name).to_json() != first.to_json()) {
            throw InputError("--merge: the parts " + parts.names.front() + " and " +
                             parts.names[i] + " do not have the same `" + name +
                             "`. Run all of them with the same options.");
        }
    }
    return first;
}

void check_complete(const JobParts& parts) {
    if (parts.missing.empty()) {
        return;
    }
    std::string names;
    for (const std::string& name : parts.missing) {
        names += (names.empty() ? "" : ", ") + name;
    }
    throw Error(ExitCode::check_failed,
                std::to_string(parts.missing.size()) + " of " +
                    std::to_string(parts.missing.size() + parts.names.size()) +
                    " parts are missing: " + names +
                    ". Run their commands, which are above, and --merge again.");
}

} // namespace raysteps
