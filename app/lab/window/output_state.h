#pragma once

#include <cstddef>
#include <optional>

/// The full-screen window with only the picture.
struct OutputState {
    bool is_open = false;
    bool is_black = false;
    std::optional<std::size_t> monitor;  // chosen by the user; nullopt: another than the panels'

    bool operator==(const OutputState&) const = default;
    /// The display to use, of `count`, if the panels are on `panels`.
    std::size_t monitor_for(std::size_t count, std::size_t panels) const;
};
