#include "screenshot.h"

#include "image/color.h"
#include "image/image_file.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

namespace raysteps::view {

Image picture_of(vtkRenderWindow& window) {
    window.Render();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(&window);
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->ShouldRerenderOff();
    filter->Update();
    vtkImageData& pixels = *filter->GetOutput();
    const int* const size = pixels.GetDimensions();
    Image image(size[0], size[1]);
    for (int row = 0; row < size[1]; ++row) {
        for (int column = 0; column < size[0]; ++column) {
            const auto* const texel = static_cast<const unsigned char*>(
                pixels.GetScalarPointer(column, size[1] - 1 - row, 0));
            for (int i = 0; i < 3; ++i) {
                image.at(column, row)[i] = linear_from_srgb(static_cast<float>(texel[i]) / 255.0f);
            }
        }
    }
    return image;
}

void write_screenshot(vtkRenderWindow& window, const std::filesystem::path& path) {
    write_png(path, picture_of(window));
}

} // namespace raysteps::view
