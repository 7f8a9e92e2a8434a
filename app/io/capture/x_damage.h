#pragma once

#include "io/capture/x_server.h"

#include <xcb/damage.h>

/// The parts of a window that programs have drawn since they were last taken.
class XDamage {
public:
    /// Reports what is drawn into `window` and its children. `server` must outlive it.
    XDamage(const XServer& server, xcb_window_t window);
    ~XDamage();
    XDamage(const XDamage&) = delete;
    XDamage& operator=(const XDamage&) = delete;

    /// Adds an event of the server; false: it does not concern this.
    bool add(const xcb_generic_event_t& event);
    void add(const ScreenArea& area);
    bool is_empty() const { return !m_area; }
    /// The bounds of everything since the last call. Later changes cause new events.
    std::optional<ScreenArea> take();

private:
    const XServer& m_server;
    xcb_damage_damage_t m_damage;
    std::optional<ScreenArea> m_area;
};
