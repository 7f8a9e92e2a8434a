#include "lab/window/output_state.h"

std::size_t OutputState::monitor_for(std::size_t count, std::size_t panels) const {
    if (monitor && *monitor < count)
        return *monitor;
    return count > 1 && panels == 0 ? 1 : 0;
}
