#include "show_in_window.h"

#include "basics/error.h"
#include "visualizer/framing.h"
#include "visualizer/keys.h"
#include "visualizer/pointing.h"
#include "visualizer/state_file.h"
#include "drawing.h"
#include "screenshot.h"

#include <vtkCallbackCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cctype>
#include <functional>
#include <iostream>

namespace raysteps::view {

namespace {

constexpr int still = 6;                     // peels of a picture that stands
constexpr int moving = 2;                    // and of one that follows the mouse
constexpr int click_room = 3;                // pixels that a click may slip
constexpr unsigned long play_interval = 300; // milliseconds a step

// VTK's trackball, with our keys and panels before it.
class Style : public vtkInteractorStyleTrackballCamera {
public:
    static Style* New();
    vtkTypeMacro(Style, vtkInteractorStyleTrackballCamera)

    std::function<void(const std::string& key)> on_key;
    std::function<void(const glm::ivec2& place)> on_panel;
    std::function<bool(const glm::ivec2& place)> is_panel;
    std::function<void(const glm::ivec2& place, bool shift)> on_click;
    std::function<void(int peels)> set_peels;
    std::function<void()> on_tick;

    // VTK's own meanings of letters, such as P and E, are not ours.
    void OnChar() override {}

    void OnKeyPress() override {
        std::string key = GetInteractor()->GetKeySym() ? GetInteractor()->GetKeySym() : "";
        if (key.size() == 1) {
            key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
        }
        on_key(key);
    }

    void OnLeftButtonDown() override {
        start_ = place();
        slides_ = is_panel(start_);
        if (slides_) {
            on_panel(start_);
            return;
        }
        set_peels(moving);
        vtkInteractorStyleTrackballCamera::OnLeftButtonDown();
    }

    void OnMouseMove() override {
        if (slides_) {
            on_panel(place());
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

// The window with its state.
class Session {
public:
    Session(const Request& request, Stage& stage)
        : state_(request.state), stage_(stage), drawing_(*window_) {
        window_->SetSize(state_.window.x, state_.window.y);
        window_->SetWindowName(title().c_str());
        interactor_->SetRenderWindow(window_);
        interactor_->SetInteractorStyle(style_);
        style_->on_key = [this](const std::string& key) { press(key); };
        style_->is_panel = [this](const glm::ivec2& place) {
            return is_on_panel(state_, stage_, place);
        };
        style_->on_panel = [this](const glm::ivec2& place) {
            show(after_click(now(), stage_, place));
        };
        style_->on_click = [this](const glm::ivec2& place, bool shift) { click(place, shift); };
        style_->set_peels = [this](int peels) { set_peels(peels); };
        style_->on_tick = [this] { play(); };
    }

    void run() {
        drawing_.draw(stage_, state_);
        window_->Render();
        interactor_->Initialize();
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

    void press(const std::string& key) {
        if (key == "q" || key == "e") {
            interactor_->TerminateApp();
        } else if (key == "F12") {
            write_new(".png", [this](const std::filesystem::path& path) {
                write_screenshot(*window_, path);
            });
        } else if (key == "k") {
            write_new(".json",
                      [this](const std::filesystem::path& path) { save_state(path, now()); });
        } else if (key == "r") {
            State next = state_;
            next.viewpoint.reset();
            show(next);
        } else if (key == "f") {
            State next = now();
            next.viewpoint = fly_to_step(stage_, next, *next.viewpoint);
            show(next);
        } else if (key == "space") {
            toggle_play();
        } else {
            show(after_key(now(), stage_, key));
        }
    }

    void click(const glm::ivec2& place, bool shift) {
        const State state = now();
        if (shift) {
            show(with_selected(state, stage_, cell_under(state, stage_, *state.viewpoint, place)));
            return;
        }
        const auto point = point_under(state, stage_, *state.viewpoint, place);
        if (point) {
            show(with_ray_to(state, stage_, *point));
        }
    }

    void toggle_play() {
        if (timer_ != 0) {
            interactor_->DestroyTimer(timer_);
            timer_ = 0;
            return;
        }
        show(after_key(now(), stage_, "Home"));
        timer_ = interactor_->CreateRepeatingTimer(play_interval);
    }

    void play() {
        if (timer_ == 0) {
            return;
        }
        if (state_.step + 1 >= step_count(stage_, state_)) {
            toggle_off();
            return;
        }
        show(after_key(now(), stage_, "n"));
    }

    void toggle_off() {
        interactor_->DestroyTimer(timer_);
        timer_ = 0;
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

    // What cannot be written is said, and the window stays.
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

    // One that no file has.
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
    Stage& stage_;
    vtkNew<vtkRenderWindow> window_;
    vtkNew<vtkRenderWindowInteractor> interactor_;
    vtkNew<Style> style_;
    Drawing drawing_;
    int timer_ = 0;
};

} // namespace

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

void show_in_window(const Request& request, Stage& stage) {
    Session(request, stage).run();
}

} // namespace raysteps::view
