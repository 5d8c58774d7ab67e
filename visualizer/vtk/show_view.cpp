#include "visualizer/request.h"

#include "basics/error.h"
#include "drawing.h"
#include "export.h"
#include "visualizer/json_files.h"
#include "visualizer/keys.h"
#include "visualizer/pointing.h"
#include "window.h"

#include <fmt/core.h>
#include <vtkCallbackCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cctype>
#include <functional>
#include <iostream>
#include <vector>

namespace raysteps::view {

namespace {

// The usual name for a picture of the state: out/view/bunny_bvh_ordered.png.
std::filesystem::path picture_path(const State& state) {
    std::string name = state.hard_case.empty() ? std::filesystem::path(state.scene).stem().string()
                                               : state.hard_case;
    for (const std::string& structure : state.structures) {
        name += "_" + structure;
    }
    for (char& letter : name) {
        letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
    }
    return std::filesystem::path("out") / "view" / (name + ".png");
}

void say_written(const std::filesystem::path& path) {
    std::cout << "wrote     " << path.string() << "\n" << std::flush;
}

constexpr int still = 6;                     // depth peels when nothing moves
constexpr int moving = 2;                    // depth peels while the mouse moves
constexpr int click_room = 3;                // pixels that the mouse may move during a click
constexpr unsigned long play_interval = 300; // milliseconds per step

// VTK's trackball; our keys and panels come first.
class Style : public vtkInteractorStyleTrackballCamera {
public:
    static Style* New();
    vtkTypeMacro(Style, vtkInteractorStyleTrackballCamera)

    std::function<void(const std::string& key)> on_key;
    std::function<void(const glm::ivec2& place, bool begins)> on_panel;
    std::function<bool(const glm::ivec2& place)> is_panel;
    std::function<void(const glm::ivec2& place, bool shift)> on_click;
    std::function<void(int peels)> set_peels;
    std::function<void()> on_tick;

    // VTK has meanings of its own for letters such as P and E.
    void OnChar() override {}

    void OnKeyPress() override {
        std::string key = GetInteractor()->GetKeySym() ? GetInteractor()->GetKeySym() : "";
        if (key.size() == 1) {
            key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
        }
        on_key((GetInteractor()->GetControlKey() != 0 ? "Control+" : "") + key);
    }

    void OnLeftButtonDown() override {
        start_ = place();
        slides_ = is_panel(start_);
        if (slides_) {
            on_panel(start_, true);
            return;
        }
        set_peels(moving);
        vtkInteractorStyleTrackballCamera::OnLeftButtonDown();
    }

    void OnMouseMove() override {
        if (slides_) {
            on_panel(place(), false);
            return;
        }
        vtkInteractorStyleTrackballCamera::OnMouseMove();
    }

    void OnLeftButtonUp() override {
        if (slides_) {
            slides_ = false;
            return;
        }
        vtkInteractorStyleTrackballCamera::OnLeftButtonUp();
        set_peels(still);
        const glm::ivec2 slipped = glm::abs(place() - start_);
        if (slipped.x <= click_room && slipped.y <= click_room) {
            on_click(place(), GetInteractor()->GetShiftKey() != 0);
        } else {
            GetInteractor()->Render();
        }
    }

    void OnTimer() override { on_tick(); }

private:
    glm::ivec2 place() {
        const int* const at = GetInteractor()->GetEventPosition();
        return {at[0], at[1]};
    }

    glm::ivec2 start_{0};
    bool slides_ = false;
};

vtkStandardNewMacro(Style)

// A window and its state.
class Session {
public:
    Session(const Request& request, Stage& stage)
        : state_(request.state), stage_(stage), drawing_(*window_) {
        window_->SetSize(state_.window.x, state_.window.y);
        interactor_->SetRenderWindow(window_);
        interactor_->SetInteractorStyle(style_);
        style_->on_key = [this](const std::string& key) { press(key); };
        style_->is_panel = [this](const glm::ivec2& place) {
            return is_on_panel(state_, stage_, place);
        };
        style_->on_panel = [this](const glm::ivec2& place, bool begins) {
            const State next = after_click(now(), stage_, place);
            begins ? change(next) : show(next); // all of a drag is one change
        };
        style_->on_click = [this](const glm::ivec2& place, bool shift) { click(place, shift); };
        style_->set_peels = [this](int peels) { set_peels(peels); };
        style_->on_tick = [this] { play(); };
    }

    void run() {
        drawing_.draw(stage_, state_);
        window_->Render();
        interactor_->Initialize();
        // Only a window that hears keys has its name: whoever drives it can wait for that.
        window_->SetWindowName(title().c_str());
        vtkNew<vtkCallbackCommand> resized;
        resized->SetClientData(this);
        resized->SetCallback([](vtkObject*, unsigned long, void* session, void*) {
            static_cast<Session*>(session)->follow_size();
        });
        window_->AddObserver(vtkCommand::WindowResizeEvent, resized);
        interactor_->Start();
    }

private:
    std::string title() const { return "Raysteps: " + stage_.scene().name; }

    // The camera is VTK's while the mouse moves it; the state then takes it over.
    State now() const {
        State state = state_;
        state.viewpoint = drawing_.viewpoint();
        return state;
    }

    void show(const State& next) {
        try {
            stage_.show(next);
            state_ = next;
        } catch (const Error& error) {
            std::cerr << "visualizer: " << error.what() << "\n";
            stage_.show(state_);
        }
        drawing_.draw(stage_, state_);
        window_->Render();
    }

    // What the user asks for, which can be undone.
    void change(const State& next) {
        done_.push_back(now());
        undone_.clear();
        show(next);
    }

    // To the newest state of the one list; where it was goes to the other.
    void go_to_last(std::vector<State>& from, std::vector<State>& back) {
        if (from.empty()) {
            return;
        }
        back.push_back(now());
        State next = from.back();
        from.pop_back();
        next.window = state_.window;
        show(next);
    }

    void press(const std::string& key) {
        switch (window_action(key)) {
        case WindowAction::quit:
            interactor_->TerminateApp();
            return;
        case WindowAction::save_picture:
            write_new(".png", [this](const std::filesystem::path& path) {
                write_screenshot(*window_, path);
            });
            return;
        case WindowAction::save_state:
            write_new(".json",
                      [this](const std::filesystem::path& path) { save_state(path, now()); });
            return;
        case WindowAction::play:
            toggle_play();
            return;
        case WindowAction::undo:
            go_to_last(done_, undone_);
            return;
        case WindowAction::redo:
            go_to_last(undone_, done_);
            return;
        case WindowAction::none:
            if (changes_state(key)) {
                change(after_key(now(), stage_, key));
            }
        }
    }

    void click(const glm::ivec2& place, bool shift) {
        const State state = now();
        if (shift) {
            change(
                with_selected(state, stage_, cell_under(state, stage_, *state.viewpoint, place)));
            return;
        }
        const auto point = point_under(state, stage_, *state.viewpoint, place);
        if (point) {
            change(with_ray_to(state, stage_, *point));
        }
    }

    void toggle_play() {
        if (timer_ != 0) {
            stop_playing();
            return;
        }
        change(after_key(now(), stage_, "Home"));
        timer_ = interactor_->CreateRepeatingTimer(play_interval);
    }

    void stop_playing() {
        interactor_->DestroyTimer(timer_);
        timer_ = 0;
    }

    void play() {
        if (timer_ == 0) {
            return;
        }
        if (state_.step + 1 >= step_count(stage_, state_)) {
            stop_playing();
            return;
        }
        show(after_key(now(), stage_, "n"));
    }

    void set_peels(int peels) {
        for (const vtkSmartPointer<vtkRenderer>& space : drawing_.spaces()) {
            space->SetMaximumNumberOfPeels(peels);
        }
    }

    void follow_size() {
        const int* const size = window_->GetSize();
        if (size[0] != state_.window.x || size[1] != state_.window.y) {
            State next = now();
            next.window = {size[0], size[1]};
            show(next);
        }
    }

    // If the file cannot be written, a message says so, and the window stays open.
    void write_new(const std::string& ending,
                   const std::function<void(const std::filesystem::path&)>& write_file) const {
        const std::filesystem::path path = new_path(ending);
        try {
            write_file(path);
            std::cout << "wrote     " << path.string() << "\n" << std::flush;
        } catch (const Error& error) {
            std::cerr << "visualizer: " << error.what() << "\n";
        }
    }

    // A name that no file has yet.
    std::filesystem::path new_path(const std::string& ending) const {
        const std::filesystem::path path = picture_path(state_).replace_extension(ending);
        std::filesystem::path numbered = path;
        for (int i = 2; std::filesystem::exists(numbered); ++i) {
            numbered = path;
            numbered.replace_filename(path.stem().string() + "_" + std::to_string(i) + ending);
        }
        return numbered;
    }

    State state_;
    std::vector<State> done_; // to go back to
    std::vector<State> undone_;
    Stage& stage_;
    vtkNew<vtkRenderWindow> window_;
    vtkNew<vtkRenderWindowInteractor> interactor_;
    vtkNew<Style> style_;
    Drawing drawing_;
    int timer_ = 0;
};

// A picture of each step: step_0001.png, step_0002.png, ...
void animate(Drawing& drawing, vtkRenderWindow& window, const Request& request,
             const Stage& stage) {
    State state = request.state;
    const int steps = step_count(stage, state);
    for (state.step = 0; state.step < steps; ++state.step) {
        drawing.draw(stage, state);
        write_screenshot(window, request.animation / fmt::format("step_{:04}.png", state.step + 1));
    }
    std::cout << "wrote     " << steps << " pictures to " << request.animation.string() << "\n";
}

void draw_without_display(const Request& request, const Stage& stage) {
    const auto window = make_headless_window(request.state.window);
    Drawing drawing(*window);
    drawing.draw(stage, request.state);
    const bool only_other_files =
        request.screenshot.empty() && (!request.exports.empty() || !request.animation.empty());
    if (!only_other_files) {
        const std::filesystem::path path =
            request.screenshot.empty() ? picture_path(request.state) : request.screenshot;
        write_screenshot(*window, path);
        say_written(path);
    }
    for (const std::filesystem::path& path : request.exports) {
        window->Render();
        export_drawing(path, stage, request.state, drawing, *window);
        say_written(path);
    }
    if (!request.animation.empty()) {
        animate(drawing, *window, request, stage);
    }
}

} // namespace

void show_view(const Request& request, Stage& stage) {
    const bool wants_files =
        !request.screenshot.empty() || !request.exports.empty() || !request.animation.empty();
    if (!wants_files && has_display()) {
        Session(request, stage).run();
        return;
    }
    if (!wants_files) {
        std::cerr << "visualizer: there is no display to open a window on, so this writes a "
                     "picture. --screenshot names its file.\n";
    }
    draw_without_display(request, stage);
}

} // namespace raysteps::view
