#pragma once

#include "io/desktop/file_chooser.h"
#include "lab/window/window_state.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

class Document;
class Messages;

/// Decides for each file dialog whether the desktop's or the program's own opens, and asks the
/// desktop's.
class DesktopFileDialog {
public:
    /// `wake` ends a wait of the window's main loop. It is called on another thread.
    explicit DesktopFileDialog(std::function<void()> wake) : m_wake(std::move(wake)) {}

    /// Call it in every update, before the panels are drawn. `parent_window`: of X11, 0: none.
    void update(WindowState& window, const Document* document, Messages& messages,
                std::uint64_t parent_window);

private:
    bool can_ask(const WindowState& window) const;

    std::function<void()> m_wake;
    std::optional<FileChooser> m_chooser;  // connected once the user wants the desktop's dialog
    bool m_is_asked = false;
};
