#include "answer.h"

#include "basics/error.h"

#include <iostream>

namespace raysteps {

namespace {

int fail(ExitCode code, const std::string& sentence) {
    std::cerr << sentence << "\n";
    return static_cast<int>(code);
}

} // namespace

int answer_job(int argc, char** argv, const std::function<Answer(const Question&)>& answer) {
    if (argc != 3) {
        return fail(ExitCode::wrong_input,
                    "Name two files: that of the questions, and one for the answers. ./course does "
                    "so.");
    }
    try {
        std::vector<Answer> answers;
        for (const Question& question : read_questions(argv[1])) {
            answers.push_back(answer(question));
        }
        write_answers(argv[2], answers);
        return static_cast<int>(ExitCode::done);
    } catch (const Error& error) {
        return fail(error.code(), error.what());
    } catch (const std::exception& error) {
        return fail(ExitCode::machine_lacks, error.what());
    }
}

} // namespace raysteps
