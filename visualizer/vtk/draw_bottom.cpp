#include "draw.h"

#include "paint.h"
#include "visualizer/replay/sentence.h"
#include "visualizer/replay/shader_line.h"
#include "visualizer/why.h"

#include <algorithm>

namespace raysteps::view {

namespace {

std::vector<std::string> lines_of_why(const Stage& stage, const State& state) {
    const auto why = why_of(stage, state);
    return why ? why->lines : std::vector<std::string>{};
}

// What the files call the triangle that a walk ends with, behind its last step.
std::string name_at_end(const Stage& stage, const RecordedWalk& walk, std::size_t step) {
    const bool is_last = step + 1 == walk.steps.size();
    const std::string name = is_last ? name_of_triangle(stage.scene(), walk.hit.triangle) : "";
    return name.empty() ? "" : " (" + name + ")";
}

constexpr int bottom_line = 22;

// The slider shows the steps of the first pane.
void draw_slider(vtkRenderer& renderer, const Area& slider, const RecordedWalk& walk, int steps,
                 std::size_t current) {
    fill(renderer, slider, {0.88f, 0.89f, 0.91f});
    const auto count = static_cast<std::size_t>(std::max(steps, 1));
    const auto place = [&](std::size_t step) {
        return slider.x + static_cast<int>(static_cast<std::size_t>(slider.width) * step / count);
    };
    // Where there are more steps than pixels, only some of them get a mark.
    std::size_t stride = 1;
    while (count / stride > static_cast<std::size_t>(slider.width)) {
        ++stride;
    }
    for (std::size_t i = 0; i < walk.steps.size(); i += stride) {
        const int left = place(i);
        const int width =
            std::max(place(i + stride) - left - (slider.width > 4 * steps ? 1 : 0), 1);
        fill(renderer, {left, slider.y + 2, width, slider.height - 4}, color_of(walk.steps[i]));
    }
    const int width = std::max(place(current + 1) - place(current), 4);
    fill(renderer, {place(current), slider.y - 2, width, slider.height + 4}, current_color);
}

std::string head_of(const Stage& stage, const Pane& pane) {
    return stage.panes().size() > 1 ? pane.label + ": " : "";
}

// A line that students write is named and not shown: pictures stand in the book.
std::string shader_text(const RecordedWalk& walk, std::size_t step) {
    if (!walk.told_by.empty()) { // by lines that are not here
        const int round = walk.steps[step].round;
        return round > 0 ? "recorded in round " + std::to_string(round) : "recorded";
    }
    const ShaderLine found = deciding_line(walk, step);
    const std::string place = "shaders/" + found.file + ":" + std::to_string(found.number);
    return found.exercise.empty() ? place + "   " + found.text
                                  : place + ", a line of exercise " + found.exercise;
}

std::string hint_of() {
    return "No ray yet: give --pixel x,y or --ray ox,oy,oz,dx,dy,dz, or click on the model or "
           "a heat map. H shows the keys.";
}

void write_parting(vtkRenderer& renderer, const Stage& stage, const State& state, int y) {
    const auto parting = parting_of(stage, state);
    std::string text = "The two walks never part.";
    if (parting) {
        text = "The walks part at step " + std::to_string(parting->first_step + 1) + " of " +
               stage.panes()[0]->label + " and step " + std::to_string(parting->second_step + 1) +
               " of " + stage.panes()[1]->label + " (D jumps " +
               (parting->first_step == parting->second_step ? "there)."
                                                            : "to one, and to the other).");
    }
    write(renderer, text, {margin, y}, {.color = faint_ink, .size = 13});
}

} // namespace

void draw_bottom(vtkRenderer& renderer, const Layout& layout, const Stage& stage,
                 const State& state) {
    int y = layout.step_slider.y - bottom_line - 2;
    const int width = layout.bottom.width - 2 * margin;
    if (!stage.ray()) {
        const std::string hint = hint_of();
        write(renderer, hint, {margin, y},
              {.color = faint_ink, .size = size_to_fit(hint, width, 15)});
        return;
    }
    const RecordedWalk& first = *walk_in(*stage.panes().front(), state);
    draw_slider(renderer, layout.step_slider, first, step_count(stage, state),
                step_in(first, state));
    for (const std::unique_ptr<Pane>& pane : stage.panes()) {
        const RecordedWalk& walk = *walk_in(*pane, state);
        if (walk.steps.empty()) {
            write(renderer, head_of(stage, *pane) + ending_of(walk), {margin, y}, {.size = 16});
            y -= 2 * bottom_line;
            continue;
        }
        const std::size_t step = step_in(walk, state);
        const std::string sentence = head_of(stage, *pane) + sentence_of(pane->cells, walk, step) +
                                     name_at_end(stage, walk, step);
        write(renderer, sentence, {margin, y}, {.size = size_to_fit(sentence, width, 16)});
        y -= bottom_line;
        const std::string text = shader_text(walk, step);
        write(renderer, text, {margin, y},
              {.color = faint_ink,
               .size = size_to_fit(text, width * 5 / 6, 14), // every letter is wide
               .font = Font::code});
        y -= bottom_line;
    }
    if (stage.panes().size() > 1) {
        write_parting(renderer, stage, state, y);
        y -= bottom_line;
    }
    for (const std::string& text : lines_of_why(stage, state)) {
        write(renderer, text, {margin, y},
              {.color = warning_ink, .size = size_to_fit(text, width, 14)});
        y -= bottom_line;
    }
    if (has_note(state)) {
        write(renderer, stage.note(), {margin, y},
              {.color = warning_ink, .size = size_to_fit(stage.note(), width, 14)});
    }
}

} // namespace raysteps::view
