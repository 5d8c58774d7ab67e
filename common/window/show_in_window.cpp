#include "window/show_in_window.h"
