#include "answer_shaders.h"

#include "basics/box.h"
#include "basics/error.h"
#include "basics/file.h"
#include "basics/random_numbers.h"
#include "gpu/draw.h"
#include "gpu/limits.h"
#include "gpu/shaders.h"
#include "image/difference.h"
#include "image/image.h"
#include "image/image_file.h"
#include "playground_file.h"
#include "render/rays.h"
#include "render/scene_textures.h"
#include "render/show_hits.h"
#include "render/trace_rays.h"
#include "render/whitted_renderer.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "structure/padding.h"
#include "structure/structure.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace raysteps {

namespace {

// Beyond it, a random ray starts nowhere near the scene.
constexpr float farthest_start = 1.5f;

constexpr int most_bounces = 3;

float aspect_ratio_of(const CourseQuestion& question) {
    return static_cast<float>(question.width) / static_cast<float>(question.height);
}

Scene scene_of(const CourseQuestion& question) {
    return load_scene(question.scene, aspect_ratio_of(question));
}

// From around the scene's box to a point in it, as an exercise wants them: most meet something.
std::vector<Ray> rays_of(const CourseQuestion& question, const Scene& scene) {
    const Box box = bounds_of(scene.corners);
    const glm::vec3 size = box.upper - box.lower;
    const float around = farthest_start * std::max({size.x, size.y, size.z});
    RandomNumbers numbers(question.seed);
    std::vector<Ray> rays = question.rays;
    for (int i = 0; i < question.random_rays; ++i) {
        const glm::vec3 target = box.lower + (0.5f * numbers.in_cube() + 0.5f) * size;
        const glm::vec3 origin = target + around * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, std::numeric_limits<float>::max()});
    }
    return rays;
}

Parts parts_of(const CourseQuestion& question) {
    return {{"triangle", find_part("triangle", question.triangle)},
            {"structure", find_part("structure", question.structure)}};
}

SceneTextures upload(const CourseQuestion& question, const Scene& scene, float reach) {
    const StructureFamily family = family_of(question.structure);
    const BuildRequest request{.reach = reach, .values = question.options};
    if (!question.packed.empty()) {
        write_file(question.packed, playground_file(scene, aspect_ratio_of(question),
                                                    std::span(&family, 1), request));
    }
    return upload(scene, family.build(scene.corners, request));
}

Found found_in(const glm::uvec4& texel) {
    return {texel.x, texel.y, texel.z, texel.w};
}

std::vector<Found> founds_in(const Texture& texture, std::size_t count) {
    const std::vector<glm::uvec4> texels = read_list(texture, count);
    std::vector<Found> found(count);
    std::transform(texels.begin(), texels.end(), found.begin(), found_in);
    return found;
}

// Each pixel as a square that can be seen and counted.
Image magnified(const Image& image) {
    constexpr int pixels = 4;
    Image large(pixels * image.width, pixels * image.height);
    for (int row = 0; row < large.height; ++row) {
        for (int column = 0; column < large.width; ++column) {
            large.at(column, row) = image.at(column / pixels, row / pixels);
        }
    }
    return large;
}

Answer answer_checkpoint(const CourseQuestion& question) {
    const Scene scene = scene_of(question);
    Answer answer{rays_of(question, scene), {}};
    const SceneTextures textures = upload(question, scene, reach_of(answer.rays, scene.corners));
    const RayTextures rays = upload_rays(answer.rays);
    const bool of_packets = has_packets(question.structure);
    Parts parts =
        of_packets ? walk_parts(question.triangle, question.structure) : parts_of(question);
    parts["checkpoint"] = question.subject;
    parts["observer"] = "observer/none.glsl";
    Program program(of_packets ? "packet_checkpoint.frag" : "checkpoint.frag", parts);
    program.set("ray_origins", rays.origins)
        .set("ray_directions", rays.directions)
        .set("triangle_count", textures.triangle_count)
        .set("triangle_corners", textures.corners)
        .set("triangle_normals", textures.normals)
        .set("triangle_materials", textures.triangle_materials)
        .set("materials", textures.materials);
    bind(program, textures.structure);
    for (const auto& [name, number] : question.numbers) {
        program.set(name, number);
    }
    for (const auto& [name, point] : question.points) {
        program.set(name, point);
    }
    for (const auto& [name, count] : question.counts) {
        program.set(name, count);
    }
    std::vector<BufferTexture> empty;
    empty.reserve(question.zeros.size());
    for (const auto& [name, count] : question.zeros) {
        const std::vector<glm::ivec4> zeros(static_cast<std::size_t>(count), glm::ivec4(0));
        empty.emplace_back(std::span(zeros));
        program.set(name, empty.back());
    }
    const Texture texture(TexelFormat::rgba32ui, rays.origins.width(), rays.origins.height());
    for (int step = 1; step <= question.steps; ++step) {
        program.set("step_number", step);
        draw(program, {.textures = {texture}});
        answer.steps.push_back(founds_in(texture, answer.rays.size()));
    }
    return answer;
}

Answer answer_rays(const CourseQuestion& question) {
    const Scene scene = scene_of(question);
    const RayTextures rays = generate_rays(
        scene.camera, question.width, question.height,
        question.subject == "interpolated" ? RayGeneration::interpolated : RayGeneration::direct);
    Answer answer{{}, {{}, {}}};
    for (const Ray& ray : read_rays(rays)) {
        const auto bits = [](const glm::vec3& point, float number) {
            return Found{
                std::bit_cast<std::uint32_t>(point.x), std::bit_cast<std::uint32_t>(point.y),
                std::bit_cast<std::uint32_t>(point.z), std::bit_cast<std::uint32_t>(number)};
        };
        answer.steps[0].push_back(bits(ray.origin, ray.t_min));
        answer.steps[1].push_back(bits(ray.direction, ray.t_max));
    }
    return answer;
}

// Measured once: what one question leaves behind does not change them.
const Limits& limits() {
    static const Limits limits = measure_limits();
    return limits;
}

Answer answer_picture(const CourseQuestion& question) {
    const Scene scene = scene_of(question);
    SceneTextures textures =
        upload(question, scene, reach_of(origins_of(scene.camera), scene.corners));
    Image image;
    if (question.subject == "whitted") {
        WhittedRenderer renderer(scene, std::move(textures), parts_of(question), limits());
        image = renderer.render(scene.camera, question.width, question.height, most_bounces);
    } else {
        TraceRays trace(parts_of(question), limits());
        const RayTextures rays =
            generate_rays(scene.camera, question.width, question.height, RayGeneration::direct);
        image = show_hits(rays, trace.closest_hits(rays, textures), textures, scene.camera,
                          scene.background, find_part("view", question.subject));
    }
    std::filesystem::path file = question.picture;
    write_pfm(file.replace_extension(".pfm"), image);
    write_png(file.replace_extension(".png"), image);
    return {};
}

// A pixel of the pictures that differs by more than this, in linear light, is wrong: a step of an
// 8-bit picture near white is 0.009, and other orders of operations stay far below.
constexpr float wrong_pixel = 0.004f;

Answer answer_difference(const CourseQuestion& question) {
    std::filesystem::path own = question.picture;
    std::filesystem::path other = question.reference;
    const Image yours = read_pfm(own.replace_extension(".pfm"));
    const Image reference = read_pfm(other.replace_extension(".pfm"));
    const Difference found = difference(yours, reference, wrong_pixel);
    Image apart(yours.width, yours.height);
    Found first{0, 0, static_cast<std::uint32_t>(found.different_pixels),
                std::bit_cast<std::uint32_t>(static_cast<float>(found.max))};
    bool seen = false;
    for (int row = 0; row < yours.height; ++row) {
        for (int column = 0; column < yours.width; ++column) {
            apart.at(column, row) = glm::abs(yours.at(column, row) - reference.at(column, row));
            const glm::vec3& by = apart.at(column, row);
            if (!seen && !(std::max({by.x, by.y, by.z}) <= wrong_pixel)) {
                seen = true;
                first[0] = static_cast<std::uint32_t>(column);
                first[1] = static_cast<std::uint32_t>(row);
            }
        }
    }
    const std::array<std::string, 3> captions{"yours", "reference", "difference"};
    const std::array<Image, 3> images{magnified(yours), magnified(reference), magnified(apart)};
    write_png(own.replace_extension(".compared.png"), side_by_side(images, captions));
    return {{}, {{first}}};
}

} // namespace

Answer answer_by_shaders(const CourseQuestion& question) {
    switch (question.kind) {
    case QuestionKind::checkpoint:
        return answer_checkpoint(question);
    case QuestionKind::rays:
        return answer_rays(question);
    case QuestionKind::picture:
        return answer_picture(question);
    case QuestionKind::difference:
        return answer_difference(question);
    case QuestionKind::builder:
    case QuestionKind::function:
        break;
    }
    throw InputError("this program answers questions about shaders. Ask course_builders.");
}

} // namespace raysteps
