#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

// The files of the conformance suite, for adapters. Everything is little-endian.
namespace suite {

struct Triangle {
    float corners[3][3];
};

struct AimedRay {
    float origin[3];
    float direction[3];
    float t_min;
    float t_max;
};

struct Answer {
    float t = std::numeric_limits<float>::max();
    float u = -1.0f; // -1 and -1: the engine does not tell
    float v = -1.0f;
    std::int32_t triangle = -1;
};

template <class Record>
std::vector<Record> read(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) {
        std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
        std::exit(2);
    }
    std::vector<Record> records(static_cast<std::size_t>(file.tellg()) / sizeof(Record));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(records.data()),
              static_cast<std::streamsize>(records.size() * sizeof(Record)));
    return records;
}

inline void write(const std::string& path, const std::vector<Answer>& answers) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(answers.data()),
               static_cast<std::streamsize>(answers.size() * sizeof(Answer)));
}

} // namespace suite
