// The panel, by Dear ImGui. It hears of the mouse from us alone, an event a frame, so that a press
// and a release that come together are both heard.
#include "program/window/panel.h"

#include "basics/error.h"

#include <imgui.h>

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace raysteps {

namespace {

constexpr float inset = 12.0f; // between the window's edge and the panel
constexpr float font_size = 14.0f;
constexpr float opacity = 0.85f;
const ImVec4 problem_color{1.0f, 0.55f, 0.5f, 1.0f};

// DejaVu grows with the screen's dots; the library's own letters are of one size.
void load_font(double scale) {
    const std::filesystem::path file = RAYSTEPS_PANEL_FONT;
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
        ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(),
                                                 font_size * static_cast<float>(scale));
    }
}

void tell_mouse(ImGuiIO& io, const PanelEvent& event, const glm::dvec2& to_pixels) {
    const ImVec2 place(static_cast<float>(event.place.x * to_pixels.x),
                       static_cast<float>(event.place.y * to_pixels.y));
    const auto notches = static_cast<float>(event.notches);
#if IMGUI_VERSION_NUM >= 18700
    io.AddMousePosEvent(place.x, place.y);
    io.AddMouseButtonEvent(0, event.pressed);
    io.AddMouseWheelEvent(0.0f, notches);
#else
    io.MousePos = place;
    io.MouseDown[0] = event.pressed;
    io.MouseWheel += notches;
#endif
}

std::string with_key(char key, const std::string& meaning) {
    return std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(key)))) + "  " +
           meaning;
}

void add_choices(const PanelContent& content, PanelWishes& wishes) {
    for (std::size_t i = 0; i < content.choices.size(); ++i) {
        const LiveChoice& choice = content.choices[i];
        if (!ImGui::BeginCombo(with_key(choice.key, choice.name).c_str(),
                               choice.words[choice.chosen].c_str(), ImGuiComboFlags_HeightLarge)) {
            continue;
        }
        for (std::size_t word = 0; word < choice.words.size(); ++word) {
            if (ImGui::Selectable(choice.words[word].c_str(), word == choice.chosen)) {
                wishes.words.push_back({i, word});
            }
        }
        ImGui::EndCombo();
    }
    if (content.reads_shaders && ImGui::SmallButton("F5  read the shaders again")) {
        wishes.read_shaders = true;
    }
}

void add_controls(PanelWishes& wishes) {
    ImGui::Separator();
    for (const ControlLine& line : control_lines()) {
        if (line.letter == 0) {
            ImGui::TextDisabled("%s: %s", line.input.c_str(), line.effect.c_str());
        } else if (ImGui::SmallButton((line.input + "  " + line.effect).c_str())) {
            wishes.letters.push_back(line.letter);
        }
    }
}

void add_text(const std::string& text) {
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void add_sayings(const PanelContent& content) {
    if (!content.milliseconds.empty()) {
        ImGui::Separator();
        const std::string last =
            std::to_string(static_cast<int>(content.milliseconds.back() + 0.5f)) + " ms a picture";
        const float most =
            *std::max_element(content.milliseconds.begin(), content.milliseconds.end());
        ImGui::PlotLines("##milliseconds", content.milliseconds.data(),
                         static_cast<int>(content.milliseconds.size()), 0, last.c_str(), 0.0f, most,
                         {ImGui::GetFontSize() * 18.0f, ImGui::GetFontSize() * 3.0f});
    }
    for (const std::string& note : content.notes) {
        add_text(note);
    }
    if (!content.command.empty()) {
        ImGui::Separator();
        add_text(content.command);
    }
    if (!content.problem.empty()) {
        ImGui::Separator();
        ImGui::PushStyleColor(ImGuiCol_Text, problem_color);
        add_text(content.problem);
        ImGui::PopStyleColor();
    }
}

} // namespace

struct Panel::Library {
    explicit Library(double scale) {
        IMGUI_CHECKVERSION();
        context = ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr; // nothing is kept from run to run
        ImGui::GetStyle().ScaleAllSizes(static_cast<float>(scale));
        load_font(scale);
        if (!ImGui_ImplOpenGL3_Init("#version 410 core")) {
            ImGui::DestroyContext(context);
            throw MachineError("window: the panel finds no OpenGL. Install the package libgl1.");
        }
    }

    ~Library() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui::DestroyContext(context);
    }

    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    // A frame that ends with ImGui::Render; says where the panel is, in pixels.
    Covered frame(const PanelContent& content, PanelWishes& wishes) {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        const ImVec2 display = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowPos({inset, inset}, ImGuiCond_FirstUseEver);
        ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {std::max(display.x - 2 * inset, 1.0f),
                                                           std::max(display.y - 2 * inset, 1.0f)});
        ImGui::SetNextWindowBgAlpha(opacity);
        ImGui::Begin("Raysteps", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
        ImGui::PushItemWidth(ImGui::GetFontSize() * 12.0f);
        add_choices(content, wishes);
        add_controls(wishes);
        add_sayings(content);
        ImGui::PopItemWidth();
        const ImVec2 from = ImGui::GetWindowPos();
        const ImVec2 size = ImGui::GetWindowSize();
        const bool list_is_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
        ImGui::End();
        ImGui::Render();
        return list_is_open ? Covered{{0.0, 0.0}, {display.x, display.y}}
                            : Covered{{from.x, from.y}, {from.x + size.x, from.y + size.y}};
    }

    ImGuiContext* context = nullptr;
};

Panel::Panel(double scale) : library_(std::make_unique<Library>(scale)) {}

Panel::~Panel() = default;

PanelWishes Panel::draw(const PanelContent& content, std::span<const PanelEvent> events,
                        const glm::dvec2& window_size, const glm::ivec2& pixels) {
    const glm::dvec2 to_pixels = glm::dvec2(pixels) / window_size;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(pixels.x), static_cast<float>(pixels.y)};
    PanelWishes wishes;
    for (const PanelEvent& event : events) {
        tell_mouse(io, event, to_pixels);
        library_->frame(content, wishes);
    }
    // What has changed its size is where it stays from the second frame on.
    library_->frame(content, wishes);
    const Covered covered = library_->frame(content, wishes);
    covered_ = {covered.from / to_pixels, covered.to / to_pixels};
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return wishes;
}

} // namespace raysteps
