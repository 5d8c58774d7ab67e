#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// A folder of its own for one test, which goes when the test ends.
class ModelFolder {
public:
    explicit ModelFolder(const std::string& test_name);
    ~ModelFolder();
    ModelFolder(const ModelFolder&) = delete;
    ModelFolder& operator=(const ModelFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, std::string_view text) const;

private:
    std::filesystem::path path_;
};

// A file of the corpus beside this one.
std::filesystem::path corpus_file(const std::string& name);

// The sentence of the error that loading ends in; empty where it ends in a scene.
std::string error_of(const std::filesystem::path& path);
std::string error_of_text(std::string_view text);

// The messages in one text, one a line, to look for words in.
std::string joined(const std::vector<std::string>& messages);
