#pragma once

#include "model/look/extent.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

struct GLFWmonitor;

namespace gpu {

/// The displays of the desktop, the primary one first. A window must exist. Queries block on the
/// display server, so they are repeated once a second.
class Displays {
public:
    std::size_t count() const { return all().size(); }
    /// The index of the display that contains a position, in screen coordinates; 0: none does.
    std::size_t at(const std::array<int, 2>& position) const;
    /// Hz; 60 if unknown.
    double refresh_rate(std::size_t display) const;
    /// Null: not connected any more.
    static GLFWmonitor* find(std::size_t display);

private:
    /// A display's position on the desktop.
    struct Display {
        std::array<int, 2> low;
        Extent size;
        int refresh_rate = 0;  // 0: unknown
    };
    const std::vector<Display>& all() const;

    mutable std::vector<Display> m_displays;
    mutable std::optional<std::chrono::steady_clock::time_point> m_read;
};

}  // namespace gpu
