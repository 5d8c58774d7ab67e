#include "catch.h"
#include "replayed.h"

using namespace raysteps;

namespace {

double fact_of(const BuiltStructure& built, const std::string& name) {
    for (const Fact& fact : built.facts) {
        if (fact.name == name) {
            return fact.value;
        }
    }
    FAIL("there is no fact " << name);
    return 0.0;
}

Scene sphere_with_more_triangles(int seed) {
    RandomNumbers numbers(seed);
    return scene_of(join(sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3), random_triangles(numbers, 200)));
}

double volume_of(const Box& box) {
    const glm::dvec3 side = glm::dvec3(box.upper) - glm::dvec3(box.lower);
    return side.x * side.y * side.z;
}

} // namespace

TEST_CASE("the cells of a structure are as many as its builder counts", "[replay][cells]") {
    const Scene scene = sphere_with_more_triangles(71);
    for (const auto& [structure, fact] :
         {std::pair{"grid", "cells"}, {"kd_restart", "nodes"}, {"bvh_skip", "nodes"}}) {
        const Replayed replayed(scene, structure, 0.0f);
        CAPTURE(structure);
        CHECK(static_cast<double>(replayed.cells.cells.size()) == fact_of(replayed.built, fact));
        double leaves = 0.0;
        double references = 0.0;
        for (const Cell& cell : replayed.cells.cells) {
            const bool counts =
                cell.leaf && (cell.triangles > 0 || structure != std::string("grid"));
            leaves += counts ? 1.0 : 0.0;
            references += cell.leaf ? cell.triangles : 0;
        }
        CHECK(leaves == fact_of(replayed.built, "leaves"));
        CHECK(references == fact_of(replayed.built, "references"));
    }
}

TEST_CASE("the costs of all cells together are the expected cost of the tree", "[replay][cells]") {
    const Scene scene = sphere_with_more_triangles(72);
    const Replayed tree(scene, "kd_restart", 0.0f);
    const Replayed hierarchy(scene, "bvh_skip", 0.0f);
    for (const auto& [replayed, costs] :
         {std::pair{&tree, CellCosts{1.0, 1.5}}, {&hierarchy, CellCosts{3.0, 1.5}}}) {
        double sum = 0.0;
        for (const Cell& cell : cells_of(replayed->built.packed, costs).cells) {
            sum += cell.cost;
        }
        // The same terms in another order, each rounded in double.
        CHECK(sum == Approx(fact_of(replayed->built, "expected_cost")).epsilon(1e-9));
        CHECK(replayed->cells.deepest == static_cast<int>(fact_of(replayed->built, "depth")));
    }
}

TEST_CASE("the leaves of a kd-tree fill its box and inner nodes are parted at their planes",
          "[replay][cells]") {
    const Replayed tree(sphere_with_more_triangles(73), "kd_restart", 0.0f);
    double leaves = 0.0;
    for (const Cell& cell : tree.cells.cells) {
        leaves += cell.leaf ? volume_of(cell.box) : 0.0;
        if (!cell.leaf) {
            REQUIRE(cell.axis != no_axis);
            CHECK(cell.box.lower[cell.axis] < cell.split);
            CHECK(cell.split < cell.box.upper[cell.axis]);
        }
    }
    // Sides are differences of floats, exact in double but for the last bits of the products.
    CHECK(leaves == Approx(volume_of(tree.cells.cells.front().box)).epsilon(1e-9));
}

TEST_CASE("an inner node counts the triangles of all leaves below it", "[replay][cells]") {
    const Replayed tree(sphere_with_more_triangles(74), "bvh_skip", 0.0f);
    CHECK(tree.cells.cells.front().triangles == triangle_count(tree.scene));
    CHECK(tree.cells.cells.front().parent == no_cell);
}

TEST_CASE("no structure has no cell and no triangle has few", "[replay][cells]") {
    CHECK(Replayed(two_triangles(), "every_triangle", 0.0f).cells.kind == CellKind::none);
    for (const std::string structure : {"grid", "kd_restart", "bvh_skip"}) {
        CAPTURE(structure);
        CHECK(Replayed(Scene{}, structure, 0.0f).cells.cells.size() <= 1);
    }
}

TEST_CASE("a cell is called by its place", "[replay][cells]") {
    StructureCells grid;
    grid.kind = CellKind::grid;
    grid.grid_cells = {4, 3, 2};
    CHECK(cell_name(grid, 0) == "cell (0,0,0)");
    CHECK(cell_name(grid, 3 + 4 * (2 + 3 * 1)) == "cell (3,2,1)");
    StructureCells tree;
    tree.kind = CellKind::bvh;
    tree.cells.resize(2);
    tree.cells[0].leaf = false;
    CHECK(cell_name(tree, 0) == "node 0");
    CHECK(cell_name(tree, 1) == "leaf 1");
}
