#include "draw.h"

#include "paint.h"
#include "visualizer/color_scale.h"
#include "visualizer/replay/sentence.h"

#include <vtkActor2D.h>
#include <vtkCoordinate.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>

#include <algorithm>
#include <array>

namespace raysteps::view {

namespace {

// Row 0 of values is the top one, of VTK's images the bottom one.
vtkSmartPointer<vtkImageData> image_of(const std::vector<float>& values, const glm::ivec2& size,
                                       const ValueRange& range) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(size.x, size.y, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int row = 0; row < size.y; ++row) {
        for (int column = 0; column < size.x; ++column) {
            const auto place = static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                               static_cast<std::size_t>(column);
            const glm::vec3 color = color_in(range, static_cast<double>(values[place]));
            auto* const texel =
                static_cast<unsigned char*>(image->GetScalarPointer(column, size.y - 1 - row, 0));
            for (int i = 0; i < 3; ++i) {
                texel[i] = static_cast<unsigned char>(255.0f * color[i] + 0.5f);
            }
        }
    }
    return image;
}

void show_image(vtkRenderer& renderer, vtkImageData& image, const Area& area) {
    const auto width = static_cast<float>(area.width);
    const auto height = static_cast<float>(area.height);
    const std::array<Rectangle, 1> whole{
        Rectangle{glm::vec3(0.0f), {width, 0.0f, 0.0f}, {0.0f, height, 0.0f}}};
    const Shape shape = rectangles(whole);
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        places->InsertNextTuple2(s, t);
    }
    shape->GetPointData()->SetTCoords(places);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(&image);
    texture->InterpolateOff();
    texture->SetColorModeToDirectScalars();
    vtkNew<vtkCoordinate> in_pixels;
    in_pixels->SetCoordinateSystemToViewport();
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    mapper->SetTransformCoordinate(in_pixels);
    vtkNew<vtkTexturedActor2D> actor;
    actor->SetMapper(mapper);
    actor->SetTexture(texture);
    actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    const int* const origin = renderer.GetOrigin();
    actor->SetPosition(area.x - origin[0], area.y - origin[1]);
    renderer.AddActor2D(actor);
}

// How many pixels there are of each colour, as bars that lie beside the colours.
void draw_histogram(vtkRenderer& renderer, const Area& area, const std::vector<float>& values,
                    const ValueRange& range) {
    constexpr int bars = 24;
    const std::vector<std::size_t> counts = histogram_of(values, range.upper, bars);
    const std::size_t most =
        std::max<std::size_t>(*std::max_element(counts.begin(), counts.end()), 1);
    for (int i = 0; i < bars; ++i) {
        const int low = area.y + area.height * i / bars;
        const int high = area.y + area.height * (i + 1) / bars;
        const glm::vec3 color = color_in({0.0, bars - 1.0}, i);
        fill(renderer, {area.x, low, 14, high - low}, color);
        const double part =
            static_cast<double>(counts[static_cast<std::size_t>(i)]) / static_cast<double>(most);
        const int length = static_cast<int>(part * (area.width - 64));
        if (length > 0) {
            fill(renderer, {area.x + 18, low + 1, length, std::max(high - low - 1, 1)},
                 {0.66f, 0.68f, 0.72f});
        }
    }
    const Writing right{.color = faint_ink, .size = 12, .side = Side::right};
    write(renderer, short_number(range.upper), {area.x + area.width, area.y + area.height - 10},
          right);
    write(renderer, "0", {area.x + area.width, area.y}, right);
}

void mark_pixel(vtkRenderer& renderer, const Area& area, const glm::ivec2& picture,
                const glm::ivec2& pixel) {
    const int x = area.x + (2 * pixel.x + 1) * area.width / (2 * picture.x);
    const int y = area.y + area.height - (2 * pixel.y + 1) * area.height / (2 * picture.y);
    const glm::vec3 white(1.0f);
    for (const auto& [dx, dy] : {std::pair{-12, 0}, {5, 0}}) {
        fill(renderer, {x + dx, y - 1, 8, 3}, white);
        fill(renderer, {x + dx, y, 8, 1}, hit_color);
        fill(renderer, {x - 1 + dy, y + dx, 3, 8}, white);
        fill(renderer, {x + dy, y + dx, 1, 8}, hit_color);
    }
}

} // namespace

void draw_heat_map(vtkRenderer& renderer, const Area& area, const Stage& stage, const State& state,
                   std::size_t number) {
    const Pane& pane = *stage.panes()[number];
    const std::vector<float> values = heat_values(pane, state.heat_map);
    const ValueRange range = heat_range(stage, state, number);
    const Area picture = picture_area(area, state.picture);
    const std::string title = heat_title(pane, state);
    write(renderer, title, {area.x + margin, area.y + area.height - 20},
          {.size = size_to_fit(title, area.width - 2 * margin, 13)});
    show_image(renderer, *image_of(values, state.picture, range), picture);
    draw_histogram(
        renderer,
        {picture.x + picture.width + 16, picture.y, histogram_width(area), picture.height}, values,
        range);
    if (state.pixel) {
        mark_pixel(renderer, picture, state.picture, *state.pixel);
    }
}

} // namespace raysteps::view
