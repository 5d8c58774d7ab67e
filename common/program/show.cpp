#include "program/show.h"

#include "image/image_file.h"
#include "program/output.h"

#include <utility>

namespace raysteps {

void show_or_write(const PictureOptions& picture, Context& context, const Camera& camera,
                   const std::string& name, const RenderPicture& render, LiveOffer offer) {
    const std::filesystem::path path = picture.out / name;
    if (picture.window) {
        show_in_window(dynamic_cast<WindowContext&>(context), camera, path, render,
                       std::move(offer));
        return;
    }
    const Image image = render(camera, picture.size.width, picture.size.height);
    write_pfm(path.string() + ".pfm", image);
    write_picture(path.string() + ".png", image);
}

} // namespace raysteps
