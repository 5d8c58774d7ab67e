#include "model_folder.h"

#include "basics/error.h"
#include "scene/obj/load_obj.h"

#include <fstream>

ModelFolder::ModelFolder(const std::string& test_name)
    : path_(std::filesystem::path(RAYSTEPS_BINARY_DIR) / "scratch" / "load_obj" / test_name) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
}

ModelFolder::~ModelFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ModelFolder::write(const std::string& name, std::string_view text) const {
    std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary)
        .write(text.data(), static_cast<std::streamsize>(text.size()));
    return path;
}

std::filesystem::path corpus_file(const std::string& name) {
    return std::filesystem::path(RAYSTEPS_SOURCE_DIR) / "tests/modules/load_obj/corpus" / name;
}

std::string error_of(const std::filesystem::path& path) {
    try {
        raysteps::load_obj(path);
    } catch (const raysteps::InputError& error) {
        return error.what();
    }
    return {};
}

std::string error_of_text(std::string_view text) {
    try {
        raysteps::parse_obj(text, "model.obj");
    } catch (const raysteps::InputError& error) {
        return error.what();
    }
    return {};
}

std::string joined(const std::vector<std::string>& messages) {
    std::string text;
    for (const std::string& message : messages)
        text += message + '\n';
    return text;
}
