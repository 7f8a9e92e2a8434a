#pragma once

#include "base/diagnostic.h"
#include "model/picture/live_spec.h"

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>
#include <xcb/xcb.h>

/// Frees what XCB returns.
struct XcbFree {
    void operator()(void* memory) const { std::free(memory); }
};
template <typename T>
using XcbReply = std::unique_ptr<T, XcbFree>;

/// The type of an event, also of one that a program sent.
inline int kind_of(const xcb_generic_event_t& event) {
    constexpr unsigned char sent_by_program = 0x80;
    return event.response_type & ~sent_by_program;
}

/// A window that its program shows to the user.
struct XWindow {
    xcb_window_t id = XCB_NONE;
    std::string title;
    bool is_own = false;  // of this process
};

/// A connection to an X server with the extensions that reading pictures needs.
class XServer {
public:
    /// `display`: ":0"; "": that of $DISPLAY. Errors have no file.
    static Result<XServer> open(const std::string& display);

    xcb_connection_t* connection() const { return m_connection.get(); }
    xcb_window_t root() const { return m_screen->root; }
    Extent extent() const { return {m_screen->width_in_pixels, m_screen->height_in_pixels}; }
    /// Whether the server has ended the connection.
    bool is_lost() const { return xcb_connection_has_error(connection()) != 0; }

    /// The windows with a title, the topmost last.
    std::vector<XWindow> windows() const;
    /// The child of the root that contains a window, such as a frame of the window manager; none:
    /// it does not exist.
    xcb_window_t top_level_of(xcb_window_t window) const;
    /// Where a window is on the screen, with the frame of its window manager; nullopt: not visible.
    std::optional<ScreenArea> place_on_screen(xcb_window_t window) const;

    /// Waits at most `seconds` for an event; null: none came.
    XcbReply<xcb_generic_event_t> wait_for_event(double seconds) const;
    /// Waits until the server has carried out all requests so far.
    void wait_for_requests() const;
    /// The first event number of XDamage.
    int first_damage_event() const { return m_first_damage_event; }

private:
    struct Disconnect {
        void operator()(xcb_connection_t* connection) const { xcb_disconnect(connection); }
    };

    XServer() = default;
    Result<void> find_extensions();
    xcb_atom_t atom(const char* name) const;
    std::string text_property(xcb_window_t window, xcb_atom_t property) const;
    std::vector<xcb_window_t> listed_windows() const;
    void add_children(xcb_window_t window, int depth, std::vector<XWindow>& found) const;
    std::optional<XWindow> described(xcb_window_t window) const;

    std::unique_ptr<xcb_connection_t, Disconnect> m_connection;
    xcb_screen_t* m_screen = nullptr;
    int m_first_damage_event = 0;
    xcb_atom_t m_utf8_title = XCB_NONE;
    xcb_atom_t m_process = XCB_NONE;
    xcb_atom_t m_clients = XCB_NONE;
};
