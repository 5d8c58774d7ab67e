#include "export.h"

#include "basics/error.h"
#include "structure/bvh/bvh_split.h"
#include "visualizer/cell_choice.h"
#include "visualizer/walk_file.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkGLTFExporter.h>
#include <vtkInformation.h>
#include <vtkJSONSceneExporter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkXMLMultiBlockDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <zip.h>

#include <algorithm>
#include <functional>

namespace raysteps::view {

namespace {

namespace fs = std::filesystem;

void add_array(vtkPolyData& shape, const std::string& name, const std::vector<int>& cells,
               const std::function<double(int number)>& value_of) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    for (const int number : cells) {
        for (int face = 0; face < 6; ++face) {
            array->InsertNextValue(value_of(number));
        }
    }
    shape.GetCellData()->AddArray(array);
}

Shape cells_of_state(const Pane& pane, const State& state) {
    const std::vector<int> cells = choose_cells(pane, state).cells;
    std::vector<Box> boxes;
    const auto cell = [&](int number) -> const Cell& {
        return pane.cells.cells[static_cast<std::size_t>(number)];
    };
    for (const int number : cells) {
        boxes.push_back(cell(number).box);
    }
    const Shape shape = box_faces(boxes);
    add_array(*shape, "number", cells, [](int number) { return number; });
    add_array(*shape, "depth", cells, [&](int number) { return cell(number).depth; });
    add_array(*shape, "triangles", cells, [&](int number) { return cell(number).triangles; });
    add_array(*shape, "area", cells, [&](int number) { return surface_area(cell(number).box); });
    add_array(*shape, "cost", cells, [&](int number) { return cell(number).cost; });
    return shape;
}

Shape rays_of(const Pane& pane) {
    std::vector<std::pair<glm::vec3, glm::vec3>> segments;
    for (const PathRay& ray : pane.path) {
        const Ray& r = ray.walk.ray;
        const bool hits = ray.walk.hit.triangle != no_triangle;
        segments.emplace_back(r.origin, r.origin + (hits ? ray.walk.hit.t : 1.0f) * r.direction);
    }
    return line_segments(segments);
}

Shape tested_by(const Stage& stage, const RecordedWalk* walk) {
    std::vector<glm::vec3> corners;
    for (const TriangleTest& test : walk ? walk->tests : std::vector<TriangleTest>{}) {
        for (std::size_t i = 0; i < 3; ++i) {
            corners.push_back(
                stage.scene().corners[3 * static_cast<std::size_t>(test.triangle) + i]);
        }
    }
    return triangles(corners);
}

void check_written(bool written, const fs::path& path) {
    if (!written || !fs::exists(path)) {
        throw InputError("--export " + path.string() +
                         ": the file cannot be written. Name another place.");
    }
}

void export_vtp(const fs::path& path, const Pane& pane, const State& state) {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(cells_of_state(pane, state));
    check_written(writer->Write() != 0, path);
}

void export_vtm(const fs::path& path, const Stage& stage, const State& state) {
    const Pane& pane = *stage.panes().front();
    vtkNew<vtkMultiBlockDataSet> blocks;
    unsigned number = 0;
    for (const auto& [name, shape] :
         {std::pair{"model", triangles(stage.scene().corners)},
          std::pair{"cells", cells_of_state(pane, state)}, std::pair{"rays", rays_of(pane)},
          std::pair{"tested", tested_by(stage, walk_in(pane, state))}}) {
        blocks->SetBlock(number, shape);
        blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name);
        ++number;
    }
    vtkNew<vtkXMLMultiBlockDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(blocks);
    check_written(writer->Write() != 0, path);
}

void export_gltf(const fs::path& path, const Drawing& drawing, vtkRenderWindow& window) {
    vtkNew<vtkGLTFExporter> exporter;
    exporter->SetFileName(path.c_str());
    exporter->SetRenderWindow(&window);
    exporter->SetActiveRenderer(drawing.spaces().front());
    exporter->InlineDataOn();
    exporter->Write();
    check_written(true, path);
}

// Writes all files of the folder to one ZIP archive.
void zip_folder(const fs::path& folder, const fs::path& archive) {
    const auto fail = [&] {
        throw InputError(archive.string() + ": the archive cannot be written. Name another place.");
    };
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    int error = 0;
    zip_t* const zip = zip_open(archive.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    if (!zip) {
        fail();
    }
    for (const fs::path& file : files) {
        const std::string name = fs::relative(file, folder).generic_string();
        zip_source_t* const source = zip_source_file(zip, file.c_str(), 0, -1);
        if (!source || zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8) < 0) {
            zip_discard(zip);
            fail();
        }
    }
    if (zip_close(zip) != 0) {
        zip_discard(zip);
        fail();
    }
}

// VTK writes a folder; the web page reads it as one archive.
void export_vtkjs(const fs::path& path, const Drawing& drawing, vtkRenderWindow& window) {
    fs::path folder = path;
    folder += ".folder";
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    vtkNew<vtkJSONSceneExporter> exporter;
    exporter->SetFileName(folder.c_str());
    exporter->SetRenderWindow(&window);
    exporter->SetActiveRenderer(drawing.spaces().front());
    exporter->Write();
    check_written(true, folder);
    zip_folder(folder, path);
    fs::remove_all(folder, ignored);
}

} // namespace

void export_drawing(const fs::path& path, const Stage& stage, const State& state,
                    const Drawing& drawing, vtkRenderWindow& window) {
    std::error_code ignored;
    if (path.has_parent_path()) {
        fs::create_directories(path.parent_path(), ignored);
    }
    const std::string form = path.extension().string();
    if (form == ".vtp") {
        export_vtp(path, *stage.panes().front(), state);
    } else if (form == ".vtm") {
        export_vtm(path, stage, state);
    } else if (form == ".gltf") {
        export_gltf(path, drawing, window);
    } else if (form == ".vtkjs") {
        export_vtkjs(path, drawing, window);
    } else if (form == ".json") {
        write_walk(path, stage, state);
    } else {
        throw InputError("--export " + path.string() +
                         ": unknown extension. Use .vtp, .vtm, .gltf, .vtkjs or .json.");
    }
}

} // namespace raysteps::view
