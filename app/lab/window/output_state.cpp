#include "lab/window/output_state.h"

void OutputState::toggle(bool overlay) {
    is_open = !is_open || is_overlay != overlay;
    is_overlay = overlay;
    is_black = false;
}

std::size_t OutputState::monitor_for(std::size_t count, std::size_t panels) const {
    if (monitor && *monitor < count)
        return *monitor;
    return count > 1 && panels == 0 ? 1 : 0;
}
