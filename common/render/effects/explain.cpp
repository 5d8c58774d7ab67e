#include "render/effects/effects_renderer.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string reason_of(const Plan& plan, Effect effect) {
    const auto call = std::find_if(plan.called.begin(), plan.called.end(),
                                   [&](const EffectCall& one) { return one.effect == effect; });
    if (call == plan.called.end()) {
        return has(plan, effect) ? "forced on" : "";
    }
    return has(plan, effect) ? call->reason : "off, though called for: " + call->reason;
}

std::string megabytes(std::size_t bytes) {
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

std::string line(const std::string& what, const std::string& text) {
    return padded(what, 10) + text + "\n";
}

} // namespace

std::string explain(const Plan& plan) {
    std::string text;
    std::string not_called;
    for (const EffectRow& row : list_effects()) {
        const std::string reason = reason_of(plan, row.effect);
        if (reason.empty()) {
            not_called += (not_called.empty() ? "" : ", ") + std::string(row.name);
        } else {
            text += line("effect", padded(std::string(row.name) + ": ", 16) + reason);
        }
    }
    if (!not_called.empty()) {
        text += line("not run", not_called);
    }
    text += line("samples", std::to_string(plan.camera_samples) +
                                (plan.camera_samples == 1 ? " ray" : " rays") + " per pixel, " +
                                std::to_string(plan.lamp_samples) + " per lamp");
    for (const PlannedPass& pass : plan.passes) {
        std::string parts;
        for (const auto& [slot, file] : pass.parts) {
            parts += (parts.empty() ? " with " : ", ") + file;
        }
        text += line("pass", pass.name + parts);
    }
    return text;
}

std::string explain(const EffectsRenderer& renderer) {
    const RayTally& tally = renderer.tally();
    std::string text;
    for (const auto& [kind, count] : kinds_of(tally)) {
        text += line("rays", padded(kind + ": ", 24) + std::to_string(count));
    }
    text += line("spared",
                 std::to_string(tally.facing_away) + " shadow rays to lamps behind the surface, " +
                     std::to_string(tally.lamps_skipped) + " lamps that no surface faces, " +
                     std::to_string(tally.faint) + " rays that would count too little");
    text += line("waves", std::to_string(tally.waves) + "; the last path ended after " +
                              std::to_string(tally.deepest) +
                              (tally.deepest == 1 ? " bounce" : " bounces"));
    text += line("memory", "arrays of effects " + megabytes(renderer.effect_bytes()) +
                               "; the longest list behind glass had " +
                               std::to_string(tally.most_listed) + " rays");
    return text;
}

} // namespace raysteps
