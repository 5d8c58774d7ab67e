#include "answer_shaders.h"

#include "random_rays.h"

#include "basics/box.h"
#include "basics/error.h"
#include "basics/file.h"
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

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <limits>
#include <utility>

namespace raysteps {

namespace {

constexpr int most_bounces = 3;

float aspect_ratio_of(const CourseQuestion& question) {
    return static_cast<float>(question.width) / static_cast<float>(question.height);
}

Scene scene_of(const CourseQuestion& question) {
    return load_scene(question.scene, aspect_ratio_of(question));
}

std::vector<Ray> rays_of(const CourseQuestion& question, const Scene& scene) {
    std::vector<Ray> rays = question.rays;
    const std::vector<Ray> random = random_rays(question, bounds_of(scene.corners));
    rays.insert(rays.end(), random.begin(), random.end());
    return rays;
}

// A structure is made for origins as far away as this, in sizes of the scene: for the farther ones
// among the rays its padding would swallow the scene.
constexpr float farthest_built_for = 1024.0f;

std::vector<Ray> built_for(const std::vector<Ray>& rays, const Scene& scene) {
    const Box box = bounds_of(scene.corners);
    const glm::vec3 size = box.upper - box.lower;
    const glm::vec3 reach(farthest_built_for * std::max({size.x, size.y, size.z}));
    std::vector<Ray> near;
    std::copy_if(rays.begin(), rays.end(), std::back_inserter(near), [&](const Ray& ray) {
        return glm::all(glm::lessThanEqual(glm::abs(ray.origin - box.lower), reach));
    });
    return near;
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

// Each texture has four of the numbers.
std::vector<Found> founds_in(const std::array<Texture, 3>& textures, std::size_t count) {
    std::vector<Found> found(count);
    for (std::size_t first = 0; const Texture& texture : textures) {
        const std::vector<glm::uvec4> texels = read_list(texture, count);
        for (std::size_t i = 0; i < count; ++i) {
            for (glm::length_t k = 0; k < 4; ++k) {
                found[i][first + static_cast<std::size_t>(k)] = texels[i][k];
            }
        }
        first += 4;
    }
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

// The scene, its structure, the rays, and the uniforms that stand in the question.
std::vector<BufferTexture> give(Program& program, const CourseQuestion& question,
                                const SceneTextures& textures, const RayTextures& rays) {
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
    return empty;
}

// A program is kept for questions that set the same uniforms: what one leaves out has its initial
// value.
Program& program_of(const std::string& pass, Parts parts, const CourseQuestion& question,
                    KeptProgram& kept) {
    parts.try_emplace("real", "real/float.glsl");
    std::string text = read_shader(pass, parts).text;
    for (const auto& [name, number] : question.numbers) {
        text += "\n" + name;
    }
    if (!kept.program || kept.text != text) {
        kept.program.reset();
        kept.program.emplace(pass, parts);
        kept.text = std::move(text);
    }
    return *kept.program;
}

Answer answer_checkpoint(const CourseQuestion& question, KeptProgram& kept) {
    const Scene scene = scene_of(question);
    Answer answer{rays_of(question, scene), {}};
    const SceneTextures textures =
        upload(question, scene, reach_of(built_for(answer.rays, scene), scene.corners));
    const RayTextures rays = upload_rays(answer.rays);
    const bool of_packets = has_packets(question.structure);
    Parts parts =
        of_packets ? walk_parts(question.triangle, question.structure) : parts_of(question);
    parts["checkpoint"] = question.subject;
    parts["observer"] = question.observer;
    Program& program = program_of(of_packets ? "packet_checkpoint.frag" : "checkpoint.frag", parts,
                                  question, kept);
    const std::vector<BufferTexture> zeros = give(program, question, textures, rays);
    const auto texture = [&rays] {
        return Texture(TexelFormat::rgba32ui, rays.origins.width(), rays.origins.height());
    };
    const std::array<Texture, 3> found{texture(), texture(), texture()};
    for (int step = 1; step <= question.steps; ++step) {
        program.set("step_number", step);
        draw(program, {.textures = {found[0], found[1], found[2]}});
        answer.steps.push_back(founds_in(found, answer.rays.size()));
    }
    return answer;
}

// Of a walk that is recorded: 64 x 64 events, and as many rounds.
constexpr int recorded_side = 64;

// Each pixel makes the whole walk again, and remembers one event of it.
Answer answer_walk(const CourseQuestion& question) {
    const Scene scene = scene_of(question);
    Answer answer{rays_of(question, scene), {}};
    if (answer.rays.size() != 1 || has_packets(question.structure)) {
        throw InputError("a walk is recorded of one ray, and not of packets. Ask so.");
    }
    const SceneTextures textures = upload(question, scene, reach_of(answer.rays, scene.corners));
    const RayTextures rays = upload_rays(answer.rays);
    Parts parts = parts_of(question);
    parts["observer"] = "record.glsl";
    Program program("record_walk.frag", parts);
    const std::vector<BufferTexture> zeros = give(program, question, textures, rays);
    program.set("any_will_do", question.subject == "any" ? 1 : 0).set("side", recorded_side);
    const std::array<Texture, 3> found{
        Texture(TexelFormat::rgba32ui, recorded_side, recorded_side),
        Texture(TexelFormat::rgba32ui, recorded_side, recorded_side),
        Texture(TexelFormat::rgba32ui, recorded_side, recorded_side)};
    draw(program, {.textures = {found[0], found[1], found[2]}});
    for (const Texture& texture : found) {
        const std::vector<glm::uvec4> texels = read_integers(texture);
        answer.steps.emplace_back(texels.size());
        std::transform(texels.begin(), texels.end(), answer.steps.back().begin(), found_in);
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

Answer answer_by_shaders(const CourseQuestion& question, KeptProgram& kept) {
    switch (question.kind) {
    case QuestionKind::checkpoint:
        return answer_checkpoint(question, kept);
    case QuestionKind::walk:
        return answer_walk(question);
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
