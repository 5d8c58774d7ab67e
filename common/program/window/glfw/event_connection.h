#pragma once

#include "program/window/controls.h"

struct GLFWwindow;

namespace raysteps {

// From its making to its end, the window's events change the controls.
class EventConnection {
public:
    EventConnection(GLFWwindow* window, Controls& controls);
    ~EventConnection();
    EventConnection(const EventConnection&) = delete;
    EventConnection& operator=(const EventConnection&) = delete;

private:
    GLFWwindow* window_;
};

} // namespace raysteps
