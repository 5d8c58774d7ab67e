#pragma once

#include "support/scratch_folder.h"

#include <filesystem>
#include <string>
#include <vector>

// The programs of the chapters: 01_rays, 02_triangles and so on.
extern const std::vector<std::string> chapters;

// What a program said, and how it ended.
struct Outcome {
    int exit_code = -1; // 124 where it took longer than a minute and a half
    std::string output;
    std::string errors;
};

// A folder in which programs are run, without a display.
class Workplace {
public:
    explicit Workplace(const std::string& name) : folder_("command_" + name) {}

    // Runs the program of a chapter in the folder.
    Outcome run(const std::string& chapter, const std::vector<std::string>& arguments) const;

    // The same; the output goes to the file or device instead.
    Outcome run_into(const std::string& output, const std::string& chapter,
                     const std::vector<std::string>& arguments) const;

    void write(const std::string& file, const std::string& text) const {
        put_bytes(folder_ / file, text);
    }
    std::string read(const std::string& file) const { return bytes_of(folder_ / file); }
    std::filesystem::path operator/(const std::string& file) const { return folder_ / file; }

    // All files in the folder and the folders in it, sorted.
    std::vector<std::string> list_files() const;

private:
    ScratchFolder folder_;
};

// Runs a program that has to refuse: with that exit code, one sentence on standard error that
// begins with the chapter, ends with a full stop and contains the fragments, and no new file.
void check_refusal(const Workplace& workplace, const std::string& chapter,
                   const std::vector<std::string>& arguments, int exit_code,
                   const std::vector<std::string>& fragments);

// The same for every chapter.
void check_refusals(const Workplace& workplace, const std::vector<std::string>& arguments,
                    int exit_code, const std::vector<std::string>& fragments);
