#include "help.h"

#include "visualizer/replay/sentence.h"
#include "state_words.h"

namespace raysteps::view {

namespace {

std::string on_or_off(bool is_on) {
    return is_on ? "on" : "off";
}

std::string axis_text(const State& state) {
    if (!state.clip) {
        return "off";
    }
    const glm::vec3& n = state.clip->normal;
    return short_number(static_cast<double>(n.x)) + "," + short_number(static_cast<double>(n.y)) +
           "," + short_number(static_cast<double>(n.z));
}

std::string step_text(const State& state) {
    return state.step < 0 ? "last" : std::to_string(state.step + 1);
}

} // namespace

std::string help_text(const State& state) {
    return " STEPS\n"
           " N  Right      next step            now " +
           step_text(state) +
           "\n"
           " P  Left       previous step\n"
           " Home  End     first, last\n"
           " Space         play\n"
           " D             where two walks part\n"
           " Tab           next ray             now " +
           std::to_string(state.path_ray) +
           "\n"
           " click         ray to that point, or of that pixel of a heat map \n"
           "\n"
           " CELLS\n"
           " V             which ones           now " +
           word_of(filter_words(), state.filter) +
           "\n"
           " C             color by             now " +
           word_of(color_words(), state.color) +
           "\n"
           " [  ]          highest level\n"
           " {  }          lowest level         now " +
           std::to_string(state.lowest_level) +
           "\n"
           " +  -          opacity              now " +
           short_number(state.opacity) +
           "\n"
           " X  Y  Z       clipping plane       now " +
           axis_text(state) +
           "\n"
           " ,  .          move it\n"
           " B             table of cells       now " +
           on_or_off(state.table) +
           "\n"
           " J  Up  Down   sort, select         now " +
           word_of(sort_words(), state.sort_by) +
           "\n"
           " Shift+click   select a cell\n"
           "\n"
           " VIEW\n"
           " mouse         orbit, move (middle), zoom (right, wheel)\n"
           " R  F          all of it, fly to the step\n"
           " W  S  T  O    model                now " +
           word_of(model_words(), state.model) +
           "\n"
           " I             heat map             now " +
           word_of(heat_map_words(), state.heat_map) +
           "\n"
           " F12  K        save picture, state\n"
           " H  Q          this sheet, quit ";
}

} // namespace raysteps::view
