#pragma once

#include <stdexcept>
#include <string>

namespace raysteps {

// How a program of Raysteps ends.
enum class ExitCode {
    done = 0,
    check_failed = 1,
    wrong_input = 2,
    machine_lacks = 3,
};

// A failure that a person can act on: one sentence that says what, where, and what to do next.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}

    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

// The person gave a file or an option that cannot be used. Ends the program with exit code 2.
class InputError : public Error {
public:
    explicit InputError(const std::string& sentence) : Error(ExitCode::wrong_input, sentence) {}
};

// The machine lacks something: OpenGL, memory, a display. Ends the program with exit code 3.
class MachineError : public Error {
public:
    explicit MachineError(const std::string& sentence) : Error(ExitCode::machine_lacks, sentence) {}
};

} // namespace raysteps
