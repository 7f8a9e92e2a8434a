#pragma once

#include <cstddef>
#include <optional>

/// The window with only the picture: full-screen, or over the window that the source shows.
struct OutputState {
    bool is_open = false;
    bool is_overlay = false;
    bool is_black = false;
    bool is_camera_on = false;           // the picture goes to a virtual camera
    std::optional<std::size_t> monitor;  // chosen by the user; nullopt: another than the panels'

    bool operator==(const OutputState&) const = default;
    /// Whether others see the picture.
    bool is_on() const { return is_open || is_camera_on; }
    /// Closes the window if it has this form, otherwise opens it with this form.
    void toggle(bool overlay);
    /// The display to use, of `count`, if the panels are on `panels`.
    std::size_t monitor_for(std::size_t count, std::size_t panels) const;
};
