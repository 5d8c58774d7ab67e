#include "prove_effects.h"

#include "basics/statistics.h"
#include "image/plot.h"
#include "measure/contest.h"
#include "render/effects/effects_renderer.h"
#include "render/whitted_renderer.h"
#include "scene/load_scene.h"
#include "structure/padding.h"
#include "trace/trace_picture.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>

namespace raysteps {

namespace {

struct SceneProof {
    SceneRecord scene;
    std::size_t different_pixels = 0;
    RayTally planned;
    RayTally everything;
    double planned_seconds = 0.0;
    double everything_seconds = 0.0;
    double chapter_03_seconds = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::pair<std::string, double>> without; // seconds without one effect
};

std::size_t count_different(const Image& a, const Image& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        different += a.pixels[i] == b.pixels[i] ? 0 : 1;
    }
    return different;
}

// The ways to render one scene; they share its structure.
class Renderings {
public:
    Renderings(const PictureSize& size, const TraceOptions& tracing, const Quality& quality,
               const std::string& name)
        : size_(size), quality_(quality), parts_(trace_parts(tracing.triangle, tracing.structure)),
          scene_(load_scene(name, aspect_ratio(size))),
          structure_(build_structure(tracing.structure, scene_.corners,
                                     {.reach = reach_of(scene_.camera.eye, scene_.corners),
                                      .values = tracing.build_values})),
          limits_(measure_limits()) {
        called_ = plan("").effects;
    }

    const Scene& scene() const { return scene_; }
    const EffectSet& called() const { return called_; }

    void add_effects(const std::string& name, const std::string& choice) {
        auto renderer = std::make_shared<EffectsRenderer>(scene_, upload(scene_, structure_),
                                                          plan(choice), parts_, limits_);
        renderers_.push_back(renderer);
        add(name, [this, renderer] {
            return renderer->render(scene_.camera, size_.width, size_.height);
        });
    }

    void add_chapter_03() {
        auto renderer =
            std::make_shared<WhittedRenderer>(scene_, upload(scene_, structure_), parts_, limits_);
        add("chapter 03", [this, renderer] {
            return renderer->render(scene_.camera, size_.width, size_.height, quality_.max_bounces);
        });
    }

    const std::vector<Contender>& contenders() const { return contenders_; }
    const Image& image(std::size_t i) const { return *images_[i]; }
    const RayTally& tally(std::size_t i) const { return renderers_[i]->tally(); }

private:
    void add(const std::string& name, const std::function<Image()>& render) {
        const auto image = std::make_shared<Image>();
        images_.push_back(image);
        contenders_.push_back({name, [=] { *image = render(); }});
    }

    Plan plan(const std::string& choice) const {
        return make_plan(scene_, static_cast<double>(size_.width) / size_.height, choice, quality_);
    }

    PictureSize size_;
    Quality quality_;
    Parts parts_;
    Scene scene_;
    BuiltStructure structure_;
    Limits limits_;
    EffectSet called_;
    std::vector<std::shared_ptr<EffectsRenderer>> renderers_;
    std::vector<std::shared_ptr<Image>> images_; // the latest of each contender
    std::vector<Contender> contenders_;
};

SceneProof prove(const PictureSize& size, const TraceOptions& tracing, const Quality& quality,
                 const std::string& scene, int rounds) {
    Renderings renderings(size, tracing, quality, scene);
    renderings.add_effects("planned", "");
    renderings.add_effects("everything", "+all");
    std::vector<std::string> names;
    for (const Effect effect : renderings.called()) {
        names.emplace_back(row_of(effect).name);
        renderings.add_effects(names.back(), "-" + names.back());
    }
    const bool is_plain = renderings.called() == EffectSet{Effect::diffuse, Effect::shadows};
    if (is_plain) {
        renderings.add_chapter_03();
    }
    std::vector<double> seconds; // of the processor, median
    for (const ContestTimes& times : run_contest(renderings.contenders(), rounds)) {
        seconds.push_back(cpu_seconds(times).median);
    }
    SceneProof result{.scene = record_of(renderings.scene()),
                      .different_pixels = count_different(renderings.image(0), renderings.image(1)),
                      .planned = renderings.tally(0),
                      .everything = renderings.tally(1),
                      .planned_seconds = seconds[0],
                      .everything_seconds = seconds[1],
                      .without = {}};
    for (std::size_t i = 0; i < names.size(); ++i) {
        result.without.emplace_back(names[i], seconds[2 + i]);
    }
    if (is_plain) {
        result.chapter_03_seconds = seconds.back();
        result.different_pixels +=
            count_different(renderings.image(0), renderings.image(seconds.size() - 1));
    }
    return result;
}

// Rays of kinds that the plan has no effect for.
long uncalled_rays(const SceneProof& proof) {
    const auto has_effect = [&](const char* name) {
        return std::any_of(proof.without.begin(), proof.without.end(),
                           [&](const auto& one) { return one.first == name; });
    };
    const auto uncalled = [&](const RayTally& tally) {
        return (has_effect("shadows") ? 0 : tally.shadow) +
               (has_effect("soft_shadows") ? 0 : tally.soft_shadow) +
               (has_effect("glass_shadows") ? 0 : tally.behind_glass) +
               (has_effect("mirrors") ? 0 : tally.mirror) +
               (has_effect("refraction") ? 0 : tally.refracted + tally.reflected_by_glass);
    };
    return uncalled(proof.planned) + uncalled(proof.everything);
}

void print(const std::vector<SceneProof>& proofs) {
    std::printf("\n| scene | rays | uncalled rays | different pixels | planned s | everything s | "
                "saved | to chapter 03 |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const SceneProof& proof : proofs) {
        std::printf("| %s | %ld | %ld | %zu | %.2f | %.2f | %.0f %% |", proof.scene.scene.c_str(),
                    all_rays(proof.planned), uncalled_rays(proof), proof.different_pixels,
                    proof.planned_seconds, proof.everything_seconds,
                    100.0 * (1.0 - proof.planned_seconds / proof.everything_seconds));
        if (std::isnan(proof.chapter_03_seconds)) {
            std::printf(" |\n");
        } else {
            std::printf(" %.2f |\n", proof.planned_seconds / proof.chapter_03_seconds);
        }
    }
    std::printf("\nWhat leaving out one of its effects saves:\n");
    for (const SceneProof& proof : proofs) {
        std::printf("%-14s", proof.scene.scene.c_str());
        for (const auto& [effect, seconds] : proof.without) {
            std::printf(" %s %.0f %%", effect.c_str(),
                        100.0 * (1.0 - seconds / proof.planned_seconds));
        }
        std::printf("\n");
    }
}

Numbers numbers_of(const std::vector<SceneProof>& proofs) {
    Numbers numbers = empty_list();
    for (const SceneProof& proof : proofs) {
        Numbers one{
            {"scene", proof.scene.scene},
            {"rays", all_rays(proof.planned)},
            {"uncalled_rays", uncalled_rays(proof)},
            {"different_pixels", proof.different_pixels},
            {"cpu_seconds",
             {{"planned", proof.planned_seconds}, {"everything", proof.everything_seconds}}},
            {"cpu_seconds_without", empty_object()}};
        if (!std::isnan(proof.chapter_03_seconds)) {
            one["cpu_seconds"]["chapter_03"] = proof.chapter_03_seconds;
        }
        for (const auto& [effect, seconds] : proof.without) {
            one["cpu_seconds_without"][effect] = seconds;
        }
        numbers.push_back(one);
    }
    return numbers;
}

void draw_chart(const std::filesystem::path& path, const std::vector<SceneProof>& proofs) {
    BarChart chart{.title = "Every effect, and the renderer of chapter 03, against the plan",
                   .y_label = "processor time; the plan takes 1",
                   .labels = {},
                   .series = {{"planned", {}}, {"everything", {}}, {"chapter 03", {}}}};
    for (const SceneProof& proof : proofs) {
        chart.labels.push_back(proof.scene.scene);
        chart.series[0].values.push_back(1.0);
        chart.series[1].values.push_back(proof.everything_seconds / proof.planned_seconds);
        chart.series[2].values.push_back(proof.chapter_03_seconds / proof.planned_seconds);
    }
    write_bar_chart(path, chart);
    print_written(path);
}

} // namespace

bool prove_effects(const PictureOptions& picture, const TraceOptions& tracing, const Proof& proof,
                   const Quality& quality) {
    std::vector<SceneProof> proofs;
    const auto progress = show_progress("proving");
    for (const std::string& scene : proof.scenes) {
        proofs.push_back(prove(picture.size, tracing, quality, scene, proof.rounds));
        progress(static_cast<double>(proofs.size()) / static_cast<double>(proof.scenes.size()));
    }
    print(proofs);
    draw_chart(picture.out / "proof.png", proofs);
    FiguresHead head{.schema = "proof.schema.json",
                     .builders = {{tracing.structure,
                                   used_build_values(tracing.structure, tracing.build_values)}}};
    for (const SceneProof& one : proofs) {
        head.scenes.push_back(one.scene);
    }
    write_figures(picture.json, head,
                  {{"structure", tracing.structure},
                   {"triangle", tracing.triangle},
                   {"scenes", numbers_of(proofs)}});
    return std::all_of(proofs.begin(), proofs.end(), [](const SceneProof& one) {
        return one.different_pixels == 0 && uncalled_rays(one) == 0;
    });
}

} // namespace raysteps
