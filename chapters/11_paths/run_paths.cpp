#include "11_paths/run_paths.h"

#include "basics/error.h"
#include "basics/text.h"
#include "basics/timed.h"
#include "image/heat_map.h"
#include "image/image_file.h"
#include "program/show.h"
#include "trace/trace_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <optional>

namespace raysteps {

namespace {

constexpr int usual_samples = 64;
constexpr int most_samples = 1 << 20;
constexpr const char* schema_name = "paths.schema.json";

// An estimate from fewer blocks is too rough to stop by.
constexpr int fewest_blocks_for_error = 4;

constexpr double bright_enough = 0.25; // the mean of a picture that is neither dark nor pale

std::string in_words(const PathChoice& choice) {
    return choice.random + " numbers, " + choice.bounce + " bounces, " + choice.heuristic +
           " heuristic, roulette " + choice.roulette + ", at most " +
           std::to_string(choice.max_bounces) + " bounces, seed " + std::to_string(choice.seed);
}

PathRun run_of(const PictureOptions& picture, const Scene& scene, const PathChoice& choice) {
    const SceneRecord record = record_of(scene);
    return {.scene = record.scene,
            .hash = record.hash,
            .camera = record.camera,
            .choice = in_words(choice),
            .width = picture.size.width,
            .height = picture.size.height};
}

double mean_without_lamps(const PathSums& sums) {
    const Image image = mean_of(sums);
    double light = 0.0;
    double pixels = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (sums.sees_lamp[i] == 0) {
            const glm::vec3& pixel = image.pixels[i];
            light += static_cast<double>(pixel.x + pixel.y + pixel.z) / 3.0;
            pixels += 1.0;
        }
    }
    return pixels > 0.0 ? light / pixels : 0.0;
}

float exposure_of(const PathSums& sums, float asked) {
    const double mean = mean_without_lamps(sums);
    return asked > 0.0f || mean <= 0.0 ? std::max(asked, 0.0f)
                                       : static_cast<float>(bright_enough / mean);
}

Image exposed(Image image, float exposure) {
    for (glm::vec3& pixel : image.pixels) {
        pixel *= exposure > 0.0f ? exposure : 1.0f;
    }
    return image;
}

std::string percent(double part) {
    return readable(100.0 * part) + " %";
}

// Pictures and what is to be known of them.
void write_pictures(const PathSums& sums, const std::filesystem::path& path, float exposure) {
    write_pfm(path.string() + ".pfm", mean_of(sums));
    write_picture(path.string() + ".png", exposed(mean_of(sums), exposure));
    if (sums.block_count() > 1) {
        std::vector<float> deviations = variance_of_mean(sums);
        const double mean = std::max(mean_without_lamps(sums), 1e-30);
        std::vector<float> without_lamps;
        for (std::size_t i = 0; i < deviations.size(); ++i) {
            deviations[i] =
                static_cast<float>(std::sqrt(static_cast<double>(deviations[i])) / mean);
            if (sums.sees_lamp[i] == 0) {
                without_lamps.push_back(deviations[i]);
            }
        }
        write_picture(path.string() + "_noise.png",
                      heat_map(deviations, sums.run.width, sums.run.height,
                               auto_range(without_lamps),
                               "standard deviation over the picture's mean"));
    }
}

void describe(const PathSums& sums, float exposure) {
    std::printf("samples   %s: %d per pixel\n", samples_in_words(sums.blocks).c_str(),
                samples_per_block * sums.block_count());
    std::printf("exposure  %s for the PNG; the PFM has the radiance, of mean %s\n",
                readable(static_cast<double>(exposure)).c_str(),
                readable(mean_without_lamps(sums)).c_str());
    const auto lamps = std::ranges::count(sums.sees_lamp, 1);
    if (sums.block_count() > 1) {
        std::printf("error     %s of the mean, estimated; %ld pixels of lamps left out\n",
                    percent(estimated_error(sums)).c_str(), static_cast<long>(lamps));
    }
    const Fireflies fireflies = fireflies_of(sums);
    if (fireflies.count > 0) {
        std::printf("fireflies %d pixels have most of their light from one block; the brightest is "
                    "column %d, row %d\n",
                    fireflies.count, fireflies.column, fireflies.row);
    }
    std::fflush(stdout);
}

void check_unbroken(const PathSums& sums) {
    if (sums.broken_count == 0) {
        return;
    }
    const BrokenMean& first = sums.broken.front();
    throw Error(ExitCode::check_failed,
                std::to_string(sums.broken_count) +
                    " blocks of a pixel are NaN or too bright to be added, and were left out: the "
                    "first is column " +
                    std::to_string(first.column) + ", row " + std::to_string(first.row) +
                    ", samples " + samples_in_words({{first.block, first.block + 1}}) +
                    ". Look there with --window, and at the emission of the scene's materials.");
}

Numbers figures_of(const PathSums& sums, float exposure) {
    const Fireflies fireflies = fireflies_of(sums);
    return {{"choice", sums.run.choice},
            {"samples", samples_in_words(sums.blocks)},
            {"samples_per_pixel", samples_per_block * sums.block_count()},
            {"mean", mean_without_lamps(sums)},
            {"estimated_error", estimated_error(sums)},
            {"exposure", exposure},
            {"lamp_pixels", static_cast<std::int64_t>(std::ranges::count(sums.sees_lamp, 1))},
            {"firefly_pixels", fireflies.count},
            {"broken_means", sums.broken_count}};
}

Numbers figures_of(const PathTally& tally) {
    return {{"primary", tally.camera}, {"bounce", tally.bounced}, {"to_lamps", tally.to_lamps}};
}

PathRenderer renderer_of(const PictureOptions& picture, const TraceOptions& tracing,
                         const PathChoice& choice, const Scene& scene) {
    const BuiltStructure built =
        build_structure(tracing.structure, scene.corners,
                        {.reach = camera_reach(picture, scene), .values = tracing.build_values});
    return {scene, upload(scene, built), choice, trace_parts(tracing.triangle, tracing.structure),
            measure_limits()};
}

// When there are enough blocks.
class Target {
public:
    Target(const PathOptions& paths, const BlockRange& blocks)
        : paths_(paths), blocks_(blocks), start_(std::chrono::steady_clock::now()) {}

    // How much is done, 0 to 1.
    double part_done(const PathSums& sums) const {
        const int count = sums.block_count();
        double part = static_cast<double>(count) / (blocks_.end - blocks_.first);
        if (paths_.seconds > 0.0) {
            const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
            part = std::max(part, passed.count() / paths_.seconds);
        }
        if (paths_.error > 0.0 && count >= fewest_blocks_for_error) {
            const double rest = paths_.error / std::max(estimated_error(sums), 1e-30);
            part = std::max(part, rest * rest); // error falls with the root of the time
        }
        return std::min(part, 1.0);
    }

private:
    const PathOptions& paths_;
    BlockRange blocks_;
    std::chrono::steady_clock::time_point start_;
};

} // namespace

void add_path_options(Options& options, PathOptions& paths) {
    PathChoice& choice = paths.choice;
    options.text("--samples", paths.samples,
                 "samples per pixel, a multiple of 16, or a part of them as in 64-127; 64 where "
                 "nothing else says when to stop");
    options.number("--seconds", paths.seconds, "begin no block of 16 samples after so long", 0.0,
                   1e6);
    options.number("--error", paths.error,
                   "stop when the estimated error is this part of the mean, as in 0.02", 0.0, 1.0);
    options.choice("--random", choice.random, "where numbers come from", part_names("random"));
    options.choice("--bounce", choice.bounce, "how paths leave matte surfaces",
                   part_names("bounce"));
    options.choice("--heuristic", choice.heuristic, "how both ways to a lamp are weighed",
                   part_names("heuristic"));
    options.choice("--roulette", choice.roulette, "which paths go on", part_names("roulette"));
    options.number("--max-bounces", choice.max_bounces,
                   "how far a path is followed; 1: no light "
                   "between surfaces",
                   0, 1000);
    options.number("--noise-seed", choice.seed, "another one gives other noise", 0);
    options.number("--exposure", paths.exposure,
                   "what radiance is multiplied by for the PNG; 0 makes the mean 0.25", 0.0f, 1e9f);
    options.number("--samples-per-part", paths.samples_per_part, "of --jobs-file: a multiple of 16",
                   samples_per_block, most_samples);
    add_job_options(options, paths.jobs);
    options.check([&paths] {
        if (!paths.samples.empty()) {
            blocks_of(paths.samples);
        }
        if (paths.samples_per_part % samples_per_block != 0) {
            throw InputError("--samples-per-part " + std::to_string(paths.samples_per_part) +
                             ": samples come in blocks of 16. Give a multiple of it.");
        }
    });
}

BlockRange blocks_of(const std::string& samples) {
    const std::vector<std::string> ends = split_words(samples, '-');
    const std::optional<int> first = ends.size() == 1 ? 0 : parse_number<int>(ends.front());
    const std::optional<int> last = parse_number<int>(ends.back());
    const int end = last.value_or(0) + (ends.size() == 1 ? 0 : 1);
    const bool fits = ends.size() <= 2 && first && last && *first % samples_per_block == 0 &&
                      end % samples_per_block == 0 && *first < end && end <= most_samples;
    if (!fits) {
        throw InputError("--samples " + samples +
                         ": samples come in blocks of 16. Give a multiple of 16, or a part that "
                         "begins at one and ends before one, as 64-127; up to " +
                         std::to_string(most_samples) + ".");
    }
    return {*first / samples_per_block, end / samples_per_block};
}

void render_paths(const PictureOptions& picture, const TraceOptions& tracing,
                  const PathOptions& paths, Context& context, const Scene& scene) {
    if (!has_light_for_paths(scene)) {
        throw InputError("--scene " + picture.scene +
                         ": nothing in it gives light. Give a material Ke, or the scene a sky or "
                         "a [[light]] (docs/scene_files.md).");
    }
    for (const std::string& sentence : left_out_of_paths(scene)) {
        std::cout << "left out  " << sentence << "\n";
    }
    PathRenderer renderer = renderer_of(picture, tracing, paths.choice, scene);
    const bool has_target = paths.seconds > 0.0 || paths.error > 0.0;
    const BlockRange blocks = blocks_of(
        !paths.samples.empty() ? paths.samples
                               : std::to_string(has_target ? most_samples : usual_samples));
    if (picture.window) {
        show_in_window(dynamic_cast<WindowContext&>(context), scene.camera,
                       picture.out / picture_name(picture.scene),
                       [&](const Camera& camera, int width, int height) {
                           PathSums sums({.width = width, .height = height});
                           for (int block = blocks.first; block < blocks.end; ++block) {
                               add_block(sums, block,
                                         renderer.render_block(camera, width, height, block));
                           }
                           return exposed(mean_of(sums), exposure_of(sums, paths.exposure));
                       });
        return;
    }
    const int width = picture.size.width; // plain names: clang 14 captures no binding
    const int height = picture.size.height;
    PathSums sums(run_of(picture, scene, paths.choice));
    sums.sees_lamp = renderer.pixels_with_lamps(scene.camera, width, height);
    const auto progress = show_progress("following paths");
    const double seconds =
        timed([&] {
            const Target target(paths, blocks);
            for (int block = blocks.first; block < blocks.end; ++block) {
                add_block(sums, block, renderer.render_block(scene.camera, width, height, block));
                const double part = target.part_done(sums);
                progress(part);
                if (part >= 1.0) {
                    break;
                }
            }
            return 0;
        }).second;
    const float exposure = exposure_of(sums, paths.exposure);
    const std::string name = picture_name(picture.scene);
    write_pictures(sums, picture.out / name, exposure);
    const bool is_part = paths.samples.find('-') != std::string::npos;
    if (is_part) {
        write_sums(picture.out / (name + ".paths"), sums);
        print_written(picture.out / (name + ".paths"));
    }
    describe(sums, exposure);
    const PathTally& tally = renderer.tally();
    const auto rays = static_cast<double>(all_rays(tally));
    std::printf("rays      %s in %.2f s: %s million per second\n", readable(rays).c_str(), seconds,
                readable(rays / seconds / 1e6).c_str());
    if (tally.cut > 0) {
        std::printf("cut       %s of %s paths were alive after %d bounces: light is missing\n",
                    readable(static_cast<double>(tally.cut)).c_str(),
                    readable(static_cast<double>(tally.camera)).c_str(), paths.choice.max_bounces);
    }
    std::fflush(stdout);
    Numbers figures{{"structure", tracing.structure}, {"triangle", tracing.triangle}};
    const Numbers of_sums = figures_of(sums, exposure);
    for (const auto& [member, value] : of_sums.members()) {
        figures[member] = value;
    }
    figures["seconds"] = seconds;
    figures["rays_by_kind"] = figures_of(tally);
    figures["million_rays_per_second"] = rays / seconds / 1e6;
    figures["cut_paths"] = tally.cut;
    if (is_part) {
        figures["sums"] = name + ".paths";
    }
    if (!picture.json.empty()) {
        write_figures(picture.json, head_of(schema_name, tracing, scene), figures);
    }
    check_unbroken(sums);
}

void write_path_jobs(const PathOptions& paths, const std::vector<std::string>& words) {
    const BlockRange blocks =
        blocks_of(paths.samples.empty() ? std::to_string(usual_samples) : paths.samples);
    const int step = paths.samples_per_part / samples_per_block;
    std::vector<RunPart> jobs;
    for (int first = blocks.first; first < blocks.end; first += step) {
        const std::string samples = samples_in_words({{first, std::min(first + step, blocks.end)}});
        jobs.push_back({"samples-" + samples, {"--samples", samples}});
    }
    write_jobs(paths.jobs, words, jobs);
}

void merge_paths(const PictureOptions& picture, const PathOptions& paths) {
    const JobParts parts = read_parts(paths.jobs.merge, schema_name);
    std::optional<PathSums> sums;
    for (std::size_t i = 0; i < parts.names.size(); ++i) {
        const std::string& file = parts.figures[i].at("sums").text();
        PathSums part = read_sums(paths.jobs.merge / parts.names[i] / file);
        sums = sums ? merged(std::move(*sums), part) : std::move(part);
    }
    const float exposure = exposure_of(*sums, paths.exposure);
    write_pictures(*sums, picture.out / picture_name(sums->run.scene), exposure);
    describe(*sums, exposure);
    check_complete(parts);
    check_unbroken(*sums);
}

} // namespace raysteps
