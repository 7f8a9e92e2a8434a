#pragma once

#include "base/diagnostic.h"

#include <cstdint>
#include <memory>
#include <string>

/// Keeps a window of this program exactly over a window of another program: it moves, changes its
/// size and is covered, hidden and closed with it. All clicks go to the window below. A thread of
/// its own does this, independent of the drawing. If the other window closes, it waits for one with
/// the same title.
class WindowOverlay {
public:
    /// Places our hidden window. `window`: its number on the X server of $DISPLAY. `title`: as for
    /// capture_window(). Errors have no file: the X server or the window is missing.
    static Result<std::unique_ptr<WindowOverlay>> open(std::uint32_t window,
                                                       const std::string& title);
    ~WindowOverlay();
    WindowOverlay(const WindowOverlay&) = delete;
    WindowOverlay& operator=(const WindowOverlay&) = delete;

private:
    class Follower;
    explicit WindowOverlay(std::unique_ptr<Follower> follower);

    std::unique_ptr<Follower> m_follower;
};
