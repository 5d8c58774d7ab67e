#include "visualizer/vtk/drawing.h"

#include "basics/error.h"
#include "catch.h"
#include "image/difference.h"
#include "image/image_file.h"
#include "modules/visualizer/shown.h"
#include "support/scratch_folder.h"
#include "visualizer/vtk/export.h"
#include "visualizer/vtk/window.h"

#include <nlohmann/json.hpp>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <fstream>
#include <set>

using namespace raysteps;
using namespace raysteps::view;

namespace {

// One window for all tests: so each is drawn over what the one before has left.
struct Canvas {
    vtkSmartPointer<vtkRenderWindow> window = make_headless_window({640, 400});
    Drawing drawing{*window};
};

Canvas& canvas() {
    static Canvas one;
    return one;
}

std::vector<DrawnPane> drawn(const Stage& stage, State state) {
    state.window = {640, 400};
    return canvas().drawing.draw(stage, state);
}

long count_cells(const Pane& pane, int level) {
    return std::count_if(pane.cells.cells.begin(), pane.cells.cells.end(),
                         [&](const Cell& cell) { return cell.depth == level; });
}

// Facts have the time that a builder took, which is never the same. The table stands in their
// place.
State picture_state(const std::string& structure) {
    State state = mirrors_state(structure);
    state.table = true;
    state.window = {1100, 700};
    return state;
}

Image picture_shown(const State& state) {
    Stage stage;
    stage.show(state);
    canvas().drawing.draw(stage, state);
    return picture_of(*canvas().window);
}

// The share of pixels that differ by more than an eighth of full light. Another version of Mesa or
// of the fonts moves edges of lines and letters by a part of a pixel. All letters and lines of
// these pictures together are about 8 in 100 of the pixels, of which a fifth may change so.
constexpr double most_different = 0.016;

void check_picture(const State& state, const std::string& name) {
    const Image image = picture_shown(state);
    const std::filesystem::path expected = std::filesystem::path(RAYSTEPS_SOURCE_DIR) /
                                           "tests/whole/drawing/expected" / (name + ".png");
    const std::filesystem::path made =
        std::filesystem::path(RAYSTEPS_BINARY_DIR) / "pictures" / ("view_" + name + ".png");
    write_png(made, image);
    CAPTURE(expected.string(), made.string());
    const Difference found = difference(image, read_picture(expected), 0.125f);
    CHECK(static_cast<double>(found.different_pixels) <
          most_different * static_cast<double>(found.pixels));
}

} // namespace

TEST_CASE("as many boxes are drawn as the structure has at a level", "[visualizer][drawing]") {
    for (const std::string structure : {"bvh_ordered", "kd_ropes", "grid"}) {
        State state = mirrors_state(structure);
        state.filter = CellFilter::all;
        Stage stage;
        stage.show(state);
        const Pane& pane = *stage.panes().front();
        for (int level = 0; level <= std::min(pane.cells.deepest, 6); ++level) {
            CAPTURE(structure, level);
            state.levels = {level, level};
            const DrawnPane found = drawn(stage, state).front();
            CHECK(found.cells + found.left_out == count_cells(pane, level));
            const long inner = std::count_if(
                pane.cells.cells.begin(), pane.cells.cells.end(),
                [&](const Cell& cell) { return cell.depth == level && cell.axis != no_axis; });
            CHECK(found.split_planes == inner);
        }
    }
}

TEST_CASE("what is drawn of a walk is what was recorded up to the step", "[visualizer][drawing]") {
    for (const std::string structure :
         {"bvh_ordered", "kd_backtrack", "grid_mailbox", "every_triangle"}) {
        State state = mirrors_state(structure);
        Stage stage;
        stage.show(state);
        const RecordedWalk& walk = *walk_in(*stage.panes().front(), state);
        const int steps = static_cast<int>(walk.steps.size());
        for (const int last : {0, 1, steps / 2, steps - 1}) {
            CAPTURE(structure, last);
            state.step = last;
            std::set<int> entered;
            std::set<int> culled;
            for (int i = 0; i <= last; ++i) {
                const Step& step = walk.steps[static_cast<std::size_t>(i)];
                if (step.cell != no_cell) {
                    (is_culled(step.outcome) ? culled : entered).insert(step.cell);
                }
            }
            const Step& step = walk.steps[static_cast<std::size_t>(last)];
            std::set<int> tested;
            for (std::size_t i = 0; i < step.end_test; ++i) {
                tested.insert(walk.tests[i].triangle);
            }
            const DrawnPane found = drawn(stage, state).front();
            CHECK(found.cells == static_cast<long>(entered.size()));
            CHECK(found.culled == static_cast<long>(culled.size()));
            CHECK(found.hits == (step.nearest.triangle == no_triangle ? 0 : 1));
            CHECK(found.tested + found.hits == static_cast<long>(tested.size()));
            CHECK(found.rays == static_cast<long>(stage.panes().front()->path.size()));
        }
    }
}

TEST_CASE("too many cells are left out and counted", "[visualizer][drawing]") {
    State state = mirrors_state("grid");
    state.filter = CellFilter::all;
    state.most_cells = 7;
    Stage stage;
    stage.show(state);
    const DrawnPane found = drawn(stage, state).front();
    CHECK(found.cells == 7);
    CHECK(found.left_out == static_cast<long>(stage.panes().front()->cells.cells.size()) - 7);
}

TEST_CASE("a ray that misses everything and a scene without a triangle are drawn",
          "[visualizer][drawing]") {
    const ScratchFolder folder("empty_scene");
    put_bytes(folder / "empty.obj", "# nothing\n");
    for (const std::string structure : {"grid", "kd_ropes", "bvh_ordered", "every_triangle"}) {
        CAPTURE(structure);
        State state;
        state.scene = (folder / "empty.obj").string();
        state.structures = {structure};
        state.ray = Ray{{50, 50, 50}, {0, 1, 0}, 0.0f, 1e30f};
        state.filter = CellFilter::visited;
        state.window = {640, 400};
        const auto refused = [&] {
            try {
                picture_shown(state);
            } catch (const InputError& error) {
                return std::string(error.what());
            }
            return std::string();
        }();
        CHECK((refused.empty() || contains_text("empty.obj").match(refused)));
        state.scene = "mirrors";
        Stage stage;
        stage.show(state);
        const DrawnPane found = drawn(stage, state).front();
        CHECK(found.rays == 1);
        CHECK(found.hits == 0);
    }
}

TEST_CASE("the pictures of a grid and two trees and two walks are the expected ones",
          "[visualizer][picture]") {
    check_picture(picture_state("grid"), "grid");
    check_picture(picture_state("kd_restart"), "kd_tree");
    check_picture(picture_state("bvh_ordered"), "bvh");
    State two = picture_state("bvh_ordered");
    two.structures = {"bvh_ordered", "bvh_skip"};
    two.heat_map = HeatMap::tests;
    check_picture(two, "two_walks");
}

TEST_CASE("a picture without the walk is not taken for the one with it", "[visualizer][picture]") {
    const Image with = picture_shown(picture_state("bvh_ordered"));
    State state = picture_state("bvh_ordered");
    state.pixel.reset();
    const Difference found = difference(with, picture_shown(state), 0.125f);
    CHECK(static_cast<double>(found.different_pixels) >
          2.0 * most_different * static_cast<double>(found.pixels));
}

TEST_CASE("a state gives the same picture whatever was drawn before", "[visualizer][picture]") {
    const State state = picture_state("kd_ropes");
    const Image first = picture_shown(state);
    State other = picture_state("grid");
    other.structures = {"grid", "bvh_skip"};
    other.heat_map = HeatMap::visits;
    other.help = true;
    picture_shown(other);
    CHECK(difference(first, picture_shown(state), 0.0f).different_pixels == 0);
}

TEST_CASE("exported files hold what is shown", "[visualizer][export]") {
    const ScratchFolder folder("view_export");
    State state = mirrors_state();
    Stage stage;
    stage.show(state);
    const DrawnPane found = drawn(stage, state).front();
    canvas().window->Render();
    const auto write = [&](const std::string& name) {
        export_drawing(folder / name, stage, state, canvas().drawing, *canvas().window);
    };
    write("cells.vtp");
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder / "cells.vtp").c_str());
    reader->Update();
    CHECK(reader->GetOutput()->GetNumberOfPolys() == 6 * found.cells);
    CHECK(reader->GetOutput()->GetCellData()->HasArray("cost") != 0);
    write("all.vtm");
    CHECK_THAT(bytes_of(folder / "all.vtm"),
               contains_text("model") && contains_text("cells") && contains_text("tested"));
    write("view.gltf");
    const auto gltf = nlohmann::json::parse(bytes_of(folder / "view.gltf"));
    CHECK(gltf.at("meshes").size() >= 5);
    write("view.vtkjs");
    const std::string archive = bytes_of(folder / "view.vtkjs");
    CHECK(archive.starts_with("PK"));
    CHECK(archive.size() > 10000);
    CHECK_THAT(archive, contains_text("index.json"));
    CHECK_THROWS_WITH(write("view.stl"), contains_text(".vtkjs"));
}
