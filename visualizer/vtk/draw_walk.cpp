#include "draw.h"

#include "paint.h"
#include "visualizer/framing.h"

#include <glm/geometric.hpp>
#include <vtkNew.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <set>

namespace raysteps::view {

namespace {

using Segment = std::pair<glm::vec3, glm::vec3>;

glm::vec3 point_at(const Ray& ray, double t) {
    return glm::vec3(glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction));
}

// A ray without an end is drawn until it is well out of the scene.
struct DrawnPart {
    double start;
    double end;
};

DrawnPart drawn_part(const Stage& stage, const Ray& ray, const Hit& hit) {
    const Box& bounds = stage.bounds();
    const double length = glm::length(glm::dvec3(ray.direction));
    if (is_empty(bounds) || length == 0.0) {
        return {0.0, length == 0.0 ? 0.0 : 1.0};
    }
    const glm::dvec3 center = 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
    const double middle =
        glm::dot(center - glm::dvec3(ray.origin), glm::dvec3(ray.direction)) / (length * length);
    const double around = 1.2 * static_cast<double>(size_of(bounds)) / length;
    const double last =
        hit.triangle != no_triangle ? static_cast<double>(hit.t) : std::max(middle, 0.0) + around;
    return {static_cast<double>(ray.t_min), std::min(last, static_cast<double>(ray.t_max))};
}

// The same, but for what lies right before the eye: there the end of a thin tube would hide all
// else.
DrawnPart part_before(const SpaceInput& input, const Ray& ray, const DrawnPart& part) {
    const double length = glm::length(glm::dvec3(ray.direction));
    const double near = 0.1 * input.distance;
    const double away = glm::distance(point_at(ray, part.start), input.eye);
    if (length == 0.0 || away >= near) {
        return part;
    }
    return {std::min(part.start + near / length, part.end), part.end};
}

void add_tubes(vtkRenderer& renderer, const std::vector<Segment>& segments, const glm::vec3& color,
               double radius) {
    if (segments.empty()) {
        return;
    }
    vtkNew<vtkTubeFilter> tube;
    tube->SetInputData(line_segments(segments));
    tube->SetRadius(radius);
    tube->SetNumberOfSides(12);
    tube->CappingOn();
    tube->Update();
    add_shape(renderer, tube->GetOutput(), {.color = color, .shaded = true});
}

void add_ball(vtkRenderer& renderer, const glm::vec3& place, const glm::vec3& color,
              double radius) {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(place.x, place.y, place.z);
    ball->SetRadius(radius);
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(16);
    ball->Update();
    add_shape(renderer, ball->GetOutput(), {.color = color, .shaded = true});
}

// All rays of the path are thin; the one that is stepped through is a little thicker.
long draw_rays(vtkRenderer& renderer, const SpaceInput& input, double radius) {
    const Pane& pane = *input.stage.panes()[input.pane];
    const RecordedWalk* current = walk_in(pane, input.state);
    for (const PathRay& ray : pane.path) {
        const DrawnPart part =
            part_before(input, ray.walk.ray, drawn_part(input.stage, ray.walk.ray, ray.walk.hit));
        const std::vector<Segment> whole{
            {point_at(ray.walk.ray, part.start), point_at(ray.walk.ray, part.end)}};
        add_tubes(renderer, whole, color_of(ray.role),
                  &ray.walk == current ? 0.75 * radius : 0.6 * radius);
        if (ray.walk.hit.triangle != no_triangle) {
            add_ball(renderer, whole.front().second, hit_color, 2.2 * radius);
        }
    }
    return static_cast<long>(pane.path.size());
}

// The pieces of the ray in the leaves, in two alternating tones so that they can be counted.
long draw_intervals(vtkRenderer& renderer, const RecordedWalk& walk, std::size_t last,
                    const DrawnPart& part, double radius) {
    std::vector<Segment> even;
    std::vector<Segment> odd;
    for (std::size_t i = 0; i <= last; ++i) {
        const Step& step = walk.steps[i];
        if (step.outcome != Outcome::leaf || step.cell == no_cell) {
            continue;
        }
        const double start = std::max(static_cast<double>(step.entry), part.start);
        const double end = std::min(static_cast<double>(step.exit), part.end);
        if (start < end) {
            ((even.size() + odd.size()) % 2 == 0 ? even : odd)
                .emplace_back(point_at(walk.ray, start), point_at(walk.ray, end));
        }
    }
    add_tubes(renderer, even, {0.00f, 0.62f, 0.45f}, 1.25 * radius);
    add_tubes(renderer, odd, {0.45f, 0.80f, 0.70f}, 1.25 * radius);
    return static_cast<long>(even.size() + odd.size());
}

long draw_culled(vtkRenderer& renderer, const SpaceInput& input, const RecordedWalk& walk,
                 std::size_t last) {
    const std::vector<Cell>& cells = input.stage.panes()[input.pane]->cells.cells;
    std::set<int> numbers;
    for (std::size_t i = 0; i <= last; ++i) {
        if (is_culled(walk.steps[i].outcome)) {
            numbers.insert(walk.steps[i].cell);
        }
    }
    std::vector<Box> boxes;
    for (const int number : numbers) {
        boxes.push_back(cells[static_cast<std::size_t>(number)].box);
    }
    if (!boxes.empty()) {
        add_shape(renderer, dashed_box_edges(boxes),
                  {.color = culled_color, .opacity = 0.8, .width = 1.2f});
    }
    return static_cast<long>(boxes.size());
}

void draw_current(vtkRenderer& renderer, const SpaceInput& input, const RecordedWalk& walk,
                  const Step& step, const DrawnPart& part, double radius) {
    if (step.cell == no_cell) {
        return;
    }
    const Cell& cell =
        input.stage.panes()[input.pane]->cells.cells[static_cast<std::size_t>(step.cell)];
    const std::vector<Box> box{cell.box};
    add_shape(renderer, box_edges(box), {.color = current_color, .width = 4.0f});
    add_shape(renderer, box_faces(box), {.color = current_color, .opacity = 0.14});
    const double start = std::max(static_cast<double>(step.entry), part.start);
    const double end = std::min(static_cast<double>(step.exit), part.end);
    if (start < end) {
        add_tubes(renderer, {{point_at(walk.ray, start), point_at(walk.ray, end)}}, current_color,
                  1.7 * radius);
    }
}

void add_corners(std::vector<glm::vec3>& corners, const Scene& scene, int triangle) {
    const auto first = 3 * static_cast<std::size_t>(triangle);
    corners.insert(corners.end(),
                   {scene.corners[first], scene.corners[first + 1], scene.corners[first + 2]});
}

// More tested triangles than this hide each other, and take long to blend.
constexpr std::size_t most_blended = 200;

struct DrawnTriangles {
    long tested = 0;
    long hits = 0;
};

// Each triangle once, however often it was tested.
DrawnTriangles draw_triangles(vtkRenderer& renderer, const SpaceInput& input,
                              const RecordedWalk& walk, std::size_t last) {
    const Scene& scene = input.stage.scene();
    const Step& step = walk.steps[last];
    std::set<int> tested;
    for (std::size_t i = 0; i < step.end_test; ++i) {
        tested.insert(walk.tests[i].triangle);
    }
    const int hit = step.nearest.triangle;
    std::vector<glm::vec3> missed;
    const auto most = static_cast<std::size_t>(std::max(input.state.most_cells, 0));
    for (const int triangle : tested) {
        if (triangle != hit && missed.size() < 3 * most) {
            add_corners(missed, scene, triangle);
        }
    }
    DrawnTriangles drawn;
    if (!missed.empty()) {
        const Shape shape = triangles(missed);
        const bool few = missed.size() <= 3 * most_blended;
        add_shape(renderer, shape, {.color = tested_color, .opacity = few ? 0.75 : 1.0});
        add_shape(renderer, shape,
                  {.color = 0.55f * tested_color, .width = 1.2f, .wireframe = true});
        drawn.tested = static_cast<long>(shape->GetNumberOfCells());
    }
    if (hit != no_triangle) {
        std::vector<glm::vec3> corners;
        add_corners(corners, scene, hit);
        const Shape shape = triangles(corners);
        add_shape(renderer, shape, {.color = hit_color});
        add_shape(renderer, shape, {.color = 0.6f * hit_color, .width = 1.6f, .wireframe = true});
        drawn.hits = 1;
    }
    return drawn;
}

} // namespace

DrawnPane draw_path(vtkRenderer& renderer, const SpaceInput& input) {
    DrawnPane drawn;
    const RecordedWalk* walk = walk_in(*input.stage.panes()[input.pane], input.state);
    if (!walk) {
        return drawn;
    }
    // Seen from close by, a ray must not hide the small boxes that it goes through.
    const double radius = std::min(0.0024 * static_cast<double>(size_of(input.stage.bounds())),
                                   0.0008 * input.distance);
    drawn.rays = draw_rays(renderer, input, radius);
    if (walk->steps.empty()) {
        return drawn;
    }
    const std::size_t last = step_in(*walk, input.state);
    const DrawnPart part =
        part_before(input, walk->ray, drawn_part(input.stage, walk->ray, walk->hit));
    drawn.intervals = draw_intervals(renderer, *walk, last, part, radius);
    drawn.culled = draw_culled(renderer, input, *walk, last);
    const DrawnTriangles tested = draw_triangles(renderer, input, *walk, last);
    drawn.tested = tested.tested;
    drawn.hits = tested.hits;
    draw_current(renderer, input, *walk, walk->steps[last], part, radius);
    return drawn;
}

} // namespace raysteps::view
