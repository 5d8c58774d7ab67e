#include "answer.h"

#include "basics/error.h"
#include "basics/file.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <cstdlib>
#include <iostream>

namespace raysteps {

namespace {

constexpr std::uintmax_t most_bytes = 64U << 20U;

nlohmann::json json_of(const Ray& ray) {
    const std::array<float, 8> numbers{ray.origin.x,    ray.origin.y,    ray.origin.z,
                                       ray.direction.x, ray.direction.y, ray.direction.z,
                                       ray.t_min,       ray.t_max};
    nlohmann::json json = nlohmann::json::array();
    for (const float number : numbers) {
        json.push_back(std::bit_cast<std::uint32_t>(number));
    }
    return json;
}

struct Outcome {
    ExitCode code = ExitCode::done;
    std::string text; // the answers, else the sentence
};

// What a job writes is its answers' text.
Outcome outcome_of(const std::function<std::string()>& job) {
    try {
        return {ExitCode::done, job()};
    } catch (const Error& error) {
        return {error.code(), error.what()};
    } catch (const std::exception& error) {
        return {ExitCode::machine_lacks, error.what()};
    }
}

// {"answers": [{"rays": [...], "steps": [...]}, ...]}, in integers.
std::string answers_of(const std::vector<CourseQuestion>& questions, const AnswerQuestion& ask) {
    nlohmann::json answers = nlohmann::json::array();
    for (const CourseQuestion& question : questions) {
        const Answer answer = ask(question);
        nlohmann::json rays = nlohmann::json::array();
        for (const Ray& ray : answer.rays) {
            rays.push_back(json_of(ray));
        }
        answers.push_back({{"rays", rays}, {"steps", answer.steps}});
    }
    return nlohmann::json{{"answers", answers}}.dump();
}

} // namespace

int answer_job(int argc, char** argv, const AnswerQuestion& answer) {
    const Outcome outcome = outcome_of([&]() -> std::string {
        if (argc != 3) {
            throw InputError("Name two files: that of the questions, and one for the answers. "
                             "./course does so.");
        }
        const Job job = parse_job(read_file(argv[1], most_bytes), argv[1]);
        write_file(argv[2], answers_of(job.questions, answer));
        return {};
    });
    if (outcome.code != ExitCode::done) {
        std::cerr << outcome.text << "\n";
    }
    return static_cast<int>(outcome.code);
}

void answer_jobs(const AnswerQuestion& answer) {
    for (std::string line; std::getline(std::cin, line);) {
        const Outcome outcome = outcome_of([&] {
            const Job job = parse_job(line, "standard input");
            setenv("RAYSTEPS_SHADERS", job.shaders.c_str(), 1); // NOLINT(concurrency-mt-unsafe)
            return answers_of(job.questions, answer);
        });
        if (outcome.code == ExitCode::done) {
            std::cout << outcome.text;
        } else {
            std::cout << nlohmann::json{{"code", static_cast<int>(outcome.code)},
                                        {"message", outcome.text}}
                             .dump();
        }
        std::cout << std::endl; // the asker waits for it
    }
}

} // namespace raysteps
