#include "make_report.h"

#include "basics/error.h"
#include "basics/file.h"
#include "circumstances.h"
#include "image/image_file.h"
#include "knobs.h"
#include "numbers.h"
#include "page.h"
#include "program/output.h"
#include "run_knob.h"
#include "scene_needs.h"
#include "structure/padding.h"
#include "tables.h"

#include <algorithm>
#include <iostream>

namespace raysteps {

namespace {

constexpr std::uintmax_t most_bytes_of_picture = 64U << 20U;
constexpr std::uintmax_t most_bytes_of_report = 256U << 20U;

// Exact truth takes a time for each ray and triangle; a family keeps so many rays at least.
constexpr std::size_t most_decisions = 400'000'000;
constexpr std::size_t fewest_rays = 1024;

std::vector<KnobMaker> chosen_knobs(const std::vector<std::string>& names) {
    std::vector<KnobMaker> chosen;
    for (const KnobMaker& maker : knob_makers()) {
        if (names.empty() || std::find(names.begin(), names.end(), maker.name) != names.end()) {
            chosen.push_back(maker);
        }
    }
    for (const std::string& name : names) {
        if (std::none_of(chosen.begin(), chosen.end(),
                         [&](const KnobMaker& maker) { return maker.name == name; })) {
            throw InputError("--knobs " + name + ": there is no such choice. Take some of " +
                             knob_names() + ".");
        }
    }
    return chosen;
}

// As many rays as a large scene leaves time for.
Effort affordable(Effort effort, const Subject& mesh) {
    const auto triangles = static_cast<std::size_t>(std::max(1, triangle_count(mesh.scene)));
    const std::size_t rays = std::max(fewest_rays, most_decisions / triangles);
    effort.judged_rays = std::min(effort.judged_rays, rays);
    effort.timed_rays = std::min(effort.timed_rays, effort.judged_rays);
    return effort;
}

std::string file_name_of(std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) == 0; }, '_');
    return text;
}

// The pictures as files, and their bytes for the page.
std::vector<PagePicture> write_pictures(const std::filesystem::path& folder,
                                        const KnobResult& result) {
    std::vector<PagePicture> pictures;
    for (const KnobPicture& picture : result.pictures) {
        const std::filesystem::path path =
            folder / "pictures" / (file_name_of(result.name + " " + picture.caption) + ".png");
        write_png(path, picture.image);
        pictures.push_back({result.name, picture.caption, read_file(path, most_bytes_of_picture)});
    }
    return pictures;
}

// Nobody should wait for minutes to learn that a file cannot be written. What is there stays.
void check_writable(const std::filesystem::path& path) {
    if (std::filesystem::is_regular_file(path)) {
        write_file(path, read_file(path, most_bytes_of_report));
        return;
    }
    write_file(path, "");
    std::filesystem::remove(path);
}

void print_advice(const std::vector<Advice>& advice) {
    std::cout << "\nWhat to take (no rank among those named together)\n";
    for (const Advice& one : advice) {
        std::cout << "  " << one.knob << ", " << one.need << " (" << one.condition << "):";
        for (std::size_t i = 0; i < one.methods.size(); ++i) {
            std::cout << (i == 0 ? " " : "; ") << one.methods[i];
        }
        std::cout << (one.methods.empty() ? " none of these\n" : "\n");
    }
}

} // namespace

Effort full_effort() {
    Effort effort;
    effort.judged_rays = 131072;
    effort.timed_rays = 16384;
    effort.rounds = 15;
    effort.picture_size = 192;
    effort.finest_grid = 1024;
    effort.most_samples = 4;
    return effort;
}

std::string knob_names() {
    std::string names;
    for (const KnobMaker& maker : knob_makers()) {
        names += (names.empty() ? "" : ", ") + maker.name;
    }
    return names;
}

void refuse_window(const PictureOptions& picture) {
    if (picture.window) {
        throw InputError("--window: the report of chapter 08 is a page. Leave the option out, and "
                         "open accuracy.html in a browser.");
    }
}

int side_of_pictures(const PictureSize& size) {
    return std::max(8, std::min(size.width, size.height));
}

void make_report(const PictureOptions& picture, const ReportRequest& request) {
    const std::vector<KnobMaker> makers = chosen_knobs(request.knobs);
    Scene scene = load_scene(picture);
    const auto context = open_context(picture);
    if (!picture.json.empty()) {
        check_writable(picture.json);
    }
    check_writable(picture.out / "accuracy.html");
    KnobRequest knobs{nullptr, nullptr, request.effort};
    knobs.effort.limits = measure_limits();
    knobs.effort.seed = request.seed;
    knobs.effort.rounds = request.rounds;
    const SceneNeeds needs = find_needs(scene);
    const float reach = reach_of(scene.camera.eye, scene.corners);
    knobs.scene = make_subject(std::move(scene), reach);
    const bool aim_at_scene = request.own_scene && needs.triangles > needs.without_area;
    knobs.mesh = aim_at_scene ? knobs.scene : usual_subject();
    knobs.effort = affordable(knobs.effort, *knobs.mesh);

    AccuracyReport report{.scene = picture.scene,
                          .circumstances = circumstances_of(knobs.effort),
                          .scene_needs = to_sentences(needs)};
    std::vector<PagePicture> pictures;
    for (const KnobMaker& maker : makers) {
        const Knob knob = maker.make(knobs);
        report.results.push_back(run_knob(knob, request.rounds, clock_of_renderer(),
                                          show_progress("comparing " + maker.name)));
        const KnobResult& result = report.results.back();
        std::cout << to_table(result) << std::flush;
        for (Advice& advice : advise(result)) {
            report.advice.push_back(std::move(advice));
        }
        for (PagePicture& page_picture : write_pictures(picture.out, result)) {
            pictures.push_back(std::move(page_picture));
        }
    }
    print_advice(report.advice);
    std::cout << "\nWhat " << picture.scene << " needs\n";
    for (const std::string& sentence : report.scene_needs) {
        std::cout << "  " << sentence << "\n";
    }
    write_text(picture.out / "accuracy.csv", to_csv(report.results));
    write_text(picture.out / "accuracy.json", to_numbers(report).to_json() + "\n");
    write_text(picture.out / "accuracy.html", to_html(report, pictures));
    write_numbers(picture.json, to_numbers(report));
}

} // namespace raysteps
