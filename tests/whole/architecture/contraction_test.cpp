#include "catch.h"
#include "multiply_add.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

// A compiler that contracts a * b + c rounds once instead of twice. That changes bits, and opens
// the edges of watertight triangles (cmake/compiler_flags.cmake).

namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

// Whether -ffp-contract=off is the last word about contraction.
bool forbids_contraction(const std::vector<std::string>& options) {
    bool forbidden = false;
    for (const std::string& option : options) {
        if (option.starts_with("-ffp-contract=")) {
            forbidden = option == "-ffp-contract=off";
        }
        if (option == "-Ofast" || option == "-ffast-math" ||
            option == "-funsafe-math-optimizations") {
            return false;
        }
    }
    return forbidden;
}

} // namespace

TEST_CASE("a product and a sum are rounded one after the other", "[architecture]") {
    // (1 + e)^2 = 1 + 2e + e^2, of which the type has no place for e^2: half a unit in the last
    // place of 1, the tie goes to the even number 1 + 2e. A fused operation keeps it.
    const float e = 0x1p-12f;
    const double f = 0x1p-27;
    REQUIRE(std::fma(1.0f + e, 1.0f + e, -(1.0f + 2.0f * e)) == e * e);
    REQUIRE(std::fma(1.0 + f, 1.0 + f, -(1.0 + 2.0 * f)) == f * f);
    if (!processor_fuses()) {
        WARN("This processor cannot fuse, so only the options of the compiler are checked.");
    }
    CHECK(multiply_add(1.0f + e, 1.0f + e, -(1.0f + 2.0f * e)) == 0.0f);
    CHECK(multiply_add(1.0 + f, 1.0 + f, -(1.0 + 2.0 * f)) == 0.0);
}

TEST_CASE("options that allow contraction are recognised", "[architecture]") {
    CHECK(forbids_contraction(words_of("g++ -O3 -ffp-contract=off -c a.cpp")));
    CHECK_FALSE(forbids_contraction(words_of("g++ -O3 -c a.cpp")));
    CHECK_FALSE(forbids_contraction(words_of("g++ -ffp-contract=off -ffp-contract=fast")));
    CHECK_FALSE(forbids_contraction(words_of("g++ -ffp-contract=off -Ofast")));
    CHECK_FALSE(forbids_contraction(words_of("g++ -ffast-math -ffp-contract=off")));
}

TEST_CASE("every file is compiled without contraction", "[architecture]") {
    const std::filesystem::path path =
        std::filesystem::path(RAYSTEPS_BINARY_DIR) / "compile_commands.json";
    CAPTURE(path.string());
    std::ifstream stream(path);
    REQUIRE(stream.good());
    const nlohmann::json commands = nlohmann::json::parse(stream);
    REQUIRE(commands.size() > 100);
    const std::vector<std::string> none;
    std::vector<std::string> contracted;
    for (const nlohmann::json& command : commands) {
        if (!forbids_contraction(words_of(command.at("command")))) {
            contracted.push_back(command.at("file"));
        }
    }
    CHECK(contracted == none);
}
