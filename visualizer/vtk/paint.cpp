#include "paint.h"

#include "basics/text.h"

#include <vtkActor2D.h>
#include <vtkCoordinate.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

namespace raysteps::view {

namespace {

constexpr int table_size = 256;

std::array<double, 3> to_vtk(const glm::vec3& color) {
    return {static_cast<double>(color.x), static_cast<double>(color.y),
            static_cast<double>(color.z)};
}

vtkSmartPointer<vtkLookupTable> color_table(const ValueRange& range) {
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(table_size);
    table->SetTableRange(range.lower, range.upper);
    for (int i = 0; i < table_size; ++i) {
        const auto color = to_vtk(color_in({0.0, table_size - 1.0}, i));
        table->SetTableValue(i, color[0], color[1], color[2]);
    }
    return table;
}

vtkSmartPointer<vtkActor> add_actor(vtkRenderer& renderer, vtkPolyDataMapper& mapper,
                                    const Look& look) {
    if (look.clip) {
        mapper.AddClippingPlane(look.clip);
    }
    vtkNew<vtkActor> actor;
    actor->SetMapper(&mapper);
    vtkProperty& property = *actor->GetProperty();
    property.SetColor(to_vtk(look.color).data());
    property.SetOpacity(look.opacity);
    property.SetLineWidth(look.width);
    property.SetLighting(look.shaded);
    property.SetAmbient(look.shaded ? 0.35 : 1.0);
    property.SetDiffuse(look.shaded ? 0.65 : 0.0);
    if (look.wireframe) {
        property.SetRepresentationToWireframe();
    }
    renderer.AddActor(actor);
    return actor;
}

// DejaVu, where it is installed: its letters are easier to tell apart than those of VTK's own
// fonts.
void choose_font(vtkTextProperty& property, Font font) {
    const std::filesystem::path folder = RAYSTEPS_FONT_DIR;
    const std::string name = font == Font::code   ? "DejaVuSansMono.ttf"
                             : font == Font::bold ? "DejaVuSans-Bold.ttf"
                                                  : "DejaVuSans.ttf";
    std::error_code ignored;
    if (std::filesystem::exists(folder / name, ignored)) {
        property.SetFontFamily(VTK_FONT_FILE);
        property.SetFontFile((folder / name).c_str());
        return;
    }
    property.SetBold(font == Font::bold);
    if (font == Font::code) {
        property.SetFontFamilyToCourier();
    } else {
        property.SetFontFamilyToArial();
    }
}

// Places are relative to the window; a renderer's coordinates start at its own corner.
glm::ivec2 corner_of(vtkRenderer& renderer) {
    const int* const origin = renderer.GetOrigin();
    return {origin[0], origin[1]};
}

} // namespace

vtkSmartPointer<vtkActor> add_shape(vtkRenderer& renderer, const Shape& shape, const Look& look) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(shape);
    mapper->ScalarVisibilityOff();
    return add_actor(renderer, *mapper, look);
}

vtkSmartPointer<vtkActor> add_valued_shape(vtkRenderer& renderer, const Shape& shape,
                                           const Look& look, const ValueRange& range) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(shape);
    mapper->SetScalarModeToUseCellData();
    mapper->SetLookupTable(color_table(range));
    mapper->UseLookupTableScalarRangeOn();
    return add_actor(renderer, *mapper, look);
}

void write(vtkRenderer& renderer, const std::string& text, const glm::ivec2& place,
           const Writing& writing) {
    vtkNew<vtkTextActor> actor;
    actor->SetInput(text.c_str());
    actor->SetTextScaleModeToNone();
    vtkTextProperty& property = *actor->GetTextProperty();
    property.SetFontSize(writing.size);
    property.SetColor(to_vtk(writing.color).data());
    choose_font(property, writing.font);
    property.SetLineSpacing(1.15);
    if (writing.side == Side::center) {
        property.SetJustificationToCentered();
    } else if (writing.side == Side::right) {
        property.SetJustificationToRight();
    }
    if (text.find('\n') != std::string::npos) {
        property.SetVerticalJustificationToTop();
    }
    if (writing.ground) {
        property.SetBackgroundColor(to_vtk(*writing.ground).data());
        property.SetBackgroundOpacity(0.75);
    }
    if (writing.boxed) {
        property.SetBackgroundColor(1.0, 1.0, 1.0);
        property.SetBackgroundOpacity(0.96);
        property.SetFrame(1);
        property.SetFrameColor(0.6, 0.62, 0.66);
    }
    const glm::ivec2 corner = corner_of(renderer);
    actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    actor->SetPosition(place.x - corner.x, place.y - corner.y);
    renderer.AddActor2D(actor);
}

void fill(vtkRenderer& renderer, const Area& area, const glm::vec3& color) {
    const std::array<Rectangle, 1> whole{Rectangle{glm::vec3(0.0f),
                                                   {static_cast<float>(area.width), 0.0f, 0.0f},
                                                   {0.0f, static_cast<float>(area.height), 0.0f}}};
    vtkNew<vtkCoordinate> in_pixels;
    in_pixels->SetCoordinateSystemToViewport();
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(rectangles(whole));
    mapper->SetTransformCoordinate(in_pixels);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(to_vtk(color).data());
    actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    const glm::ivec2 origin = corner_of(renderer);
    actor->SetPosition(area.x - origin.x, area.y - origin.y);
    renderer.AddActor2D(actor);
}

int size_to_fit(const std::string& text, int width, int most) {
    std::size_t longest = 1;
    for (const std::string& line : split_words(text, '\n')) {
        longest = std::max(longest, line.size());
    }
    const auto letters = static_cast<double>(longest);
    return std::clamp(static_cast<int>(width / (0.5 * letters)), 9, most);
}

void place_renderer(vtkRenderer& renderer, const Area& area, const glm::ivec2& window) {
    const double width = window.x;
    const double height = window.y;
    renderer.SetViewport(area.x / width, area.y / height, (area.x + area.width) / width,
                         (area.y + area.height) / height);
}

} // namespace raysteps::view
