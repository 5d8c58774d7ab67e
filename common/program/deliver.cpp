#include "program/deliver.h"

#include "basics/error.h"
#include "basics/file.h"
#include "image/image_file.h"

#include <cctype>
#include <iostream>

namespace raysteps {

void deliver(const Command& command, Context& context, const Camera& camera,
             const std::string& name, const RenderPicture& render) {
    if (command.window) {
        show_in_window(dynamic_cast<WindowContext&>(context), camera, command.out / name, render);
        return;
    }
    const Image image = render(camera, command.width, command.height);
    const std::filesystem::path linear = command.out / (name + ".pfm");
    write_pfm(linear, image);
    deliver_picture(command, image, name);
}

void deliver_picture(const Command& command, const Image& image, const std::string& name) {
    const std::filesystem::path path = command.out / (name + ".png");
    write_png(path, image);
    std::cout << "wrote     " << path.string() << "\n" << std::flush;
}

void deliver_numbers(const Command& command, const nlohmann::ordered_json& numbers) {
    if (command.json.empty()) {
        return;
    }
    write_file(command.json, numbers.dump(2) + "\n");
    std::cout << "wrote     " << command.json.string() << "\n";
}

std::string picture_name(const Command& command) {
    std::string name = std::filesystem::path(command.scene).stem().string();
    for (char& letter : name) {
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '-') {
            letter = '_';
        }
    }
    return name;
}

} // namespace raysteps
