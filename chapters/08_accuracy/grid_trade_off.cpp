#include "trade_offs.h"

#include "basics/random_numbers.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/grid/grid.h"
#include "structure/padding.h"

#include <algorithm>
#include <limits>

namespace raysteps {

namespace {

constexpr double too_close = 5.0 * 0x1p-24;

float plane_of(const GridShape& shape, int axis, int i) {
    return grid_plane(shape.lower[axis], shape.cell_size[axis], i);
}

// The cell that the ray starts in: a plane that it stands on is still before it.
int first_cell(const GridShape& shape, const Ray& ray, int axis) {
    int cell = 0;
    while (cell + 1 < shape.cells[axis] && plane_of(shape, axis, cell + 1) < ray.origin[axis]) {
        ++cell;
    }
    return cell;
}

double leaving(const GridShape& shape, const Ray& ray, int axis, int cell) {
    const double along = static_cast<double>(ray.direction[axis]);
    if (along == 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const int plane = along > 0.0 ? cell + 1 : cell;
    return (static_cast<double>(plane_of(shape, axis, plane)) -
            static_cast<double>(ray.origin[axis])) /
           along;
}

struct GridMethod {
    std::string name;
    std::string file;
};

const std::vector<GridMethod>& grid_methods() {
    static const std::vector<GridMethod> all{{"from the index", "structure/grid/grid.glsl"},
                                             {"added up", "exhibit/grid_accumulated.glsl"}};
    return all;
}

Parts parts_of(const GridMethod& method) {
    return {{"triangle", "triangle/watertight.glsl"}, {"structure", method.file}};
}

// A flat grid of so many cells an axis, with nothing in it: only the cells count.
Grid empty_grid(int resolution) {
    Grid grid;
    grid.shape.cells = {resolution, resolution, 1};
    grid.shape.cell_size = glm::vec3(1.0f / static_cast<float>(resolution));
    grid.shape.cell_size.z = 1.0f;
    grid.starts.assign(static_cast<std::size_t>(cell_count(grid.shape)) + 1, 0);
    grid.references = {0}; // of no cell: an array on the GPU has one number at least
    return grid;
}

// From the corner of the grid across it.
std::vector<Ray> rays_across(const Effort& effort) {
    RandomNumbers numbers(effort.seed);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < effort.judged_rays; ++i) {
        const glm::vec3 origin(0.01f * numbers.unit(), 0.01f * numbers.unit(), 0.5f);
        const glm::vec3 direction(0.5f + 0.5f * numbers.unit(), 0.5f + 0.5f * numbers.unit(), 0.0f);
        rays.push_back({origin, direction, 0.0f, no_end});
    }
    return rays;
}

// A walk of so many cells takes long.
std::size_t timed_count(const Effort& effort) {
    return std::min<std::size_t>({effort.timed_rays, effort.judged_rays, 1024});
}

struct TrailFamily {
    std::vector<Ray> rays;
    std::vector<GridTrail> truth;
    SceneTextures scene;
    RayTextures all;
    RayTextures timed;
};

std::shared_ptr<const TrailFamily> make_trails(int resolution, const Effort& effort) {
    const Grid grid = empty_grid(resolution);
    std::vector<Ray> rays = rays_across(effort);
    std::vector<GridTrail> truth;
    for (const Ray& ray : rays) {
        truth.push_back(grid_trail(grid.shape, ray));
    }
    const Mesh aside = triangle({9.0f, 9.0f, 9.0f}, {10.0f, 9.0f, 9.0f}, {9.0f, 10.0f, 9.0f});
    SceneTextures scene = upload(add_mesh({}, aside, Material{}), BuiltStructure{pack(grid), {}});
    RayTextures all = upload_rays(rays);
    RayTextures timed = upload_rays(std::span(rays).first(timed_count(effort)));
    return std::make_shared<const TrailFamily>(TrailFamily{
        std::move(rays), std::move(truth), std::move(scene), std::move(all), std::move(timed)});
}

Findings judge_trails(std::span<const glm::uvec4> observed, std::span<const GridTrail> truth) {
    Fault strayed{"other cells", 0, truth.size()};
    double close = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const bool differs = observed[i].x != truth[i].visits || observed[i].y != truth[i].mixed;
        strayed.count += differs && !truth[i].is_close ? 1 : 0;
        close += differs && truth[i].is_close ? 1.0 : 0.0;
    }
    return {{strayed}, std::nullopt, {{"at edges of cells", close}}};
}

void add_trails(TradeOffTrials& trade_off, int resolution, const Effort& effort) {
    const auto family = make_trails(resolution, effort);
    for (const GridMethod& method : grid_methods()) {
        const auto trace = std::make_shared<TraceRays>(parts_of(method), effort.limits);
        Parts watched = parts_of(method);
        watched["observer"] = "exhibit/trail_observer.glsl";
        const auto watch = std::make_shared<TraceRays>(std::move(watched), effort.limits);
        trade_off.trials.push_back(
            {.method = method.name,
             .family = std::to_string(resolution) + " cells across",
             .timed_cases = timed_count(effort),
             .run = [=] { trace->closest_hits(family->timed, family->scene); },
             .examine =
                 [=] {
                     watch->closest_hits(family->all, family->scene);
                     return judge_trails(read_list(*watch->observations(), family->rays.size()),
                                         family->truth);
                 }});
    }
}

// Crumbs all over the unit cube, each smaller than a cell.
Scene crumbs(int seed) {
    RandomNumbers numbers(seed);
    Mesh mesh;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 a = numbers.in_cube();
        mesh = join(std::move(mesh), triangle(a, a + glm::vec3(0.004f, 0.001f, 0.0f),
                                              a + glm::vec3(0.0f, 0.003f, 0.004f)));
    }
    return add_mesh({}, mesh, Material{});
}

void add_hits(TradeOffTrials& trade_off, const Effort& effort) {
    const auto scene = std::make_shared<const Scene>(crumbs(effort.seed));
    std::vector<RayFamily> rays =
        families_from_inside(scene->corners, effort.judged_rays, effort.seed);
    std::erase_if(rays, [](const RayFamily& family) { return family.name != "inside"; });
    rays.front().name = "at crumbs";
    const float reach = reach_of(rays.front().rays, scene->corners);
    const auto textures = build_textures(*scene, "grid", reach, {{"resolution", "64"}});
    std::vector<TraceMethod> methods;
    for (const GridMethod& method : grid_methods()) {
        methods.push_back({method.name, parts_of(method), textures});
    }
    for (MethodTrial& trial :
         trace_trials(methods, with_truth(std::move(rays), scene->corners, effort), scene->corners,
                      effort)) {
        trial.examine = [examine = std::move(trial.examine), scene] { return examine(); };
        trade_off.trials.push_back(std::move(trial));
    }
}

} // namespace

GridTrail grid_trail(const GridShape& shape, const Ray& ray) {
    glm::ivec3 cell(0);
    glm::dvec3 leaves(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = first_cell(shape, ray, axis);
        leaves[axis] = leaving(shape, ray, axis, cell[axis]);
    }
    GridTrail trail;
    for (;;) {
        const int number = cell.x + shape.cells.x * (cell.y + shape.cells.y * cell.z);
        ++trail.visits;
        trail.mixed = (trail.mixed ^ static_cast<std::uint32_t>(number)) * 16777619U;
        int axis = leaves.x <= leaves.y ? 0 : 1;
        axis = leaves[axis] <= leaves.z ? axis : 2;
        for (int other = 0; other < 3; ++other) {
            const bool within = leaves[other] - leaves[axis] <= too_close * leaves[axis];
            trail.is_close = trail.is_close || (other != axis && within);
        }
        cell[axis] += ray.direction[axis] > 0.0f ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= shape.cells[axis] || ray.direction[axis] == 0.0f) {
            return trail;
        }
        leaves[axis] = leaving(shape, ray, axis, cell[axis]);
    }
}

TradeOffTrials grid_trade_off(const Effort& effort) {
    TradeOffTrials trade_off;
    trade_off.name = "grid stepping";
    trade_off.question = "Where does a walk through a grid meet the next plane?";
    trade_off.unit_of_cases = "ray";
    trade_off.unit_of_error = "t, in ulp";
    for (const int resolution : {64, 256, effort.finest_grid}) {
        add_trails(trade_off, resolution, effort);
    }
    add_hits(trade_off, effort);
    return trade_off;
}

} // namespace raysteps
