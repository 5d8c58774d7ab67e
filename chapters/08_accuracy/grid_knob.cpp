#include "grid_knob.h"

#include "basics/random_numbers.h"
#include "grid_trail.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/grid/grid.h"
#include "structure/padding.h"
#include "subject.h"
#include "trace_trials.h"

#include <algorithm>

namespace raysteps {

namespace {

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
    std::vector<Trail> truth;
    SceneTextures scene;
    RayTextures all;
    RayTextures timed;
};

std::shared_ptr<const TrailFamily> make_trails(int resolution, const Effort& effort) {
    const Grid grid = empty_grid(resolution);
    std::vector<Ray> rays = rays_across(effort);
    std::vector<Trail> truth;
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

Findings judge_trails(std::span<const glm::uvec4> observed, std::span<const Trail> truth) {
    Fault strayed{"other cells", 0, truth.size()};
    double close = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const bool differs = observed[i].x != truth[i].visits || observed[i].y != truth[i].mixed;
        strayed.count += differs && !truth[i].is_close ? 1 : 0;
        close += differs && truth[i].is_close ? 1.0 : 0.0;
    }
    return {{strayed}, std::nullopt, {{"at edges of cells", close}}};
}

void add_trails(Knob& knob, int resolution, const Effort& effort) {
    const auto family = make_trails(resolution, effort);
    for (const GridMethod& method : grid_methods()) {
        const auto trace = std::make_shared<TraceRays>(parts_of(method), effort.limits);
        Parts watched = parts_of(method);
        watched["observer"] = "exhibit/trail_observer.glsl";
        const auto watch = std::make_shared<TraceRays>(std::move(watched), effort.limits);
        knob.trials.push_back({.method = method.name,
                               .family = std::to_string(resolution) + " cells across",
                               .timed_cases = timed_count(effort),
                               .run = [=] { trace->closest_hits(family->timed, family->scene); },
                               .examine =
                                   [=] {
                                       watch->closest_hits(family->all, family->scene);
                                       return judge_trails(read_integers(*watch->observations()),
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

void add_hits(Knob& knob, const Effort& effort) {
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
    for (Trial& trial : trace_trials(methods, with_truth(std::move(rays), scene->corners, effort),
                                     scene->corners, effort)) {
        trial.examine = [examine = std::move(trial.examine), scene] { return examine(); };
        knob.trials.push_back(std::move(trial));
    }
}

} // namespace

Knob grid_knob(const Effort& effort) {
    Knob knob;
    knob.name = "grid stepping";
    knob.question = "Where does a walk through a grid meet the next plane?";
    knob.unit_of_cases = "ray";
    knob.unit_of_error = "t, in ulp";
    for (const int resolution : {64, 256, effort.finest_grid}) {
        add_trails(knob, resolution, effort);
    }
    add_hits(knob, effort);
    return knob;
}

} // namespace raysteps
