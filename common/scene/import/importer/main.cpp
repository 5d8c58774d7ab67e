// The importer: reads a model by a library that does not stop at every fault, and hands over a mesh
// file. A program of its own, so that its end is not that of the program that needs the model.
//
//   raysteps_importer MODEL ANSWER
//
// The answer is the mesh file, or, where the exit code is not 0, a sentence.
#include "basics/error.h"
#include "basics/file.h"
#include "scene/import/importer/import_file.h"

#include <algorithm>
#include <exception>
#include <new>

#include <sys/resource.h>
#include <unistd.h>

namespace {

constexpr rlim_t most_processor_seconds = 300;
constexpr unsigned most_seconds = 900;

// Three quarters of the machine's memory: what is left is for the program that waits.
void limit_itself() {
    const auto pages = static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES));
    const auto page = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    const rlimit memory{pages * page / 4 * 3, pages * page / 4 * 3};
    const rlimit processor{most_processor_seconds, most_processor_seconds};
    const rlimit core{0, 0};
#if !defined(__SANITIZE_ADDRESS__) // which takes address space by the terabyte
    setrlimit(RLIMIT_AS, &memory);
#endif
    setrlimit(RLIMIT_CPU, &processor);
    setrlimit(RLIMIT_CORE, &core);
    alarm(most_seconds);
}

int answer(const char* path, const std::string& text, raysteps::ExitCode code) {
    raysteps::write_file(path, text);
    return static_cast<int>(code);
}

} // namespace

int main(int argc, char** argv) {
    using namespace raysteps;
    if (argc != 3) {
        return static_cast<int>(ExitCode::wrong_input);
    }
    limit_itself();
    try {
        return answer(argv[2], write_mesh_file(import_file(argv[1])), ExitCode::done);
    } catch (const Error& error) {
        return answer(argv[2], error.what(), error.code());
    } catch (const std::bad_alloc&) {
        return answer(argv[2],
                      "it is too large for the memory of this machine. Close other programs, or "
                      "load a smaller model.",
                      ExitCode::machine_lacks);
    } catch (const std::exception& error) {
        return answer(argv[2],
                      std::string("it cannot be imported (") + error.what() +
                          "). Check the export, or try another format.",
                      ExitCode::wrong_input);
    }
}
