#include "io/capture/x_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <poll.h>
#include <unistd.h>
#include <xcb/composite.h>
#include <xcb/damage.h>
#include <xcb/shm.h>
#include <xcb/xfixes.h>

namespace {
constexpr std::uint32_t most_property_words = 1024;
constexpr int deepest_client = 4;  // a window manager's frame has few levels

xcb_screen_t* screen_of(xcb_connection_t* connection, int number) {
    auto screens = xcb_setup_roots_iterator(xcb_get_setup(connection));
    for (; screens.rem > 1 && number > 0; --number)
        xcb_screen_next(&screens);
    return screens.data;
}

bool has(xcb_connection_t* connection, xcb_extension_t& extension) {
    const xcb_query_extension_reply_t* reply = xcb_get_extension_data(connection, &extension);
    return reply && reply->present;
}
}  // namespace

Result<XServer> XServer::open(const std::string& display) {
    XServer server;
    int number = 0;
    server.m_connection.reset(xcb_connect(display.empty() ? nullptr : display.c_str(), &number));
    if (server.is_lost())
        return fail({{},
                     0,
                     display.empty()
                         ? std::string("no X display found. Start an X11 session, or set $DISPLAY.")
                         : fmt::format("can't open the X display '{}'", display)});
    server.m_screen = screen_of(server.connection(), number);
    if (auto found = server.find_extensions(); !found)
        return fail(found.error());
    server.m_utf8_title = server.atom("_NET_WM_NAME");
    server.m_process = server.atom("_NET_WM_PID");
    server.m_clients = server.atom("_NET_CLIENT_LIST_STACKING");
    return server;
}

// A server answers requests of these extensions only after it was asked for their versions.
Result<void> XServer::find_extensions() {
    xcb_connection_t* const x = connection();
    for (xcb_extension_t* extension : {&xcb_composite_id, &xcb_damage_id, &xcb_xfixes_id})
        if (!has(x, *extension))
            return fail({{}, 0, "the X server lacks Composite, Damage or XFixes"});
    const XcbReply<xcb_composite_query_version_reply_t> composite(
        xcb_composite_query_version_reply(x, xcb_composite_query_version(x, 0, 2), nullptr));
    const XcbReply<xcb_damage_query_version_reply_t> damage(
        xcb_damage_query_version_reply(x, xcb_damage_query_version(x, 1, 1), nullptr));
    const XcbReply<xcb_xfixes_query_version_reply_t> fixes(
        xcb_xfixes_query_version_reply(x, xcb_xfixes_query_version(x, 4, 0), nullptr));
    if (!composite || !damage || !fixes || composite->minor_version < 2)
        return fail({{}, 0, "the X server's Composite extension is too old"});
    m_first_damage_event = xcb_get_extension_data(x, &xcb_damage_id)->first_event;
    return {};
}

xcb_atom_t XServer::atom(const char* name) const {
    const XcbReply<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(
        connection(),
        xcb_intern_atom(connection(), 0, static_cast<std::uint16_t>(std::strlen(name)), name),
        nullptr));
    return reply ? reply->atom : XCB_NONE;
}

std::string XServer::text_property(xcb_window_t window, xcb_atom_t property) const {
    const XcbReply<xcb_get_property_reply_t> reply(
        xcb_get_property_reply(connection(),
                               xcb_get_property(connection(), 0, window, property,
                                                XCB_GET_PROPERTY_TYPE_ANY, 0, most_property_words),
                               nullptr));
    if (!reply || reply->format != 8)
        return {};
    const auto length = static_cast<std::size_t>(xcb_get_property_value_length(reply.get()));
    return {static_cast<const char*>(xcb_get_property_value(reply.get())), length};
}

// The window manager's list; empty: there is none.
std::vector<xcb_window_t> XServer::listed_windows() const {
    const XcbReply<xcb_get_property_reply_t> reply(
        xcb_get_property_reply(connection(),
                               xcb_get_property(connection(), 0, root(), m_clients, XCB_ATOM_WINDOW,
                                                0, most_property_words),
                               nullptr));
    if (!reply || reply->format != 32)
        return {};
    const auto count =
        static_cast<std::size_t>(xcb_get_property_value_length(reply.get())) / sizeof(xcb_window_t);
    std::vector<xcb_window_t> windows(count);
    std::memcpy(windows.data(), xcb_get_property_value(reply.get()), count * sizeof(xcb_window_t));
    return windows;
}

std::optional<XWindow> XServer::described(xcb_window_t window) const {
    XWindow found{.id = window, .title = text_property(window, m_utf8_title)};
    if (found.title.empty())
        found.title = text_property(window, XCB_ATOM_WM_NAME);
    if (found.title.empty())
        return std::nullopt;
    const XcbReply<xcb_get_property_reply_t> process(xcb_get_property_reply(
        connection(), xcb_get_property(connection(), 0, window, m_process, XCB_ATOM_CARDINAL, 0, 1),
        nullptr));
    std::uint32_t number = 0;
    if (process && process->format == 32 && xcb_get_property_value_length(process.get()) == 4)
        std::memcpy(&number, xcb_get_property_value(process.get()), sizeof number);
    found.is_own = number == static_cast<std::uint32_t>(::getpid());
    return found;
}

void XServer::add_children(xcb_window_t window, int depth, std::vector<XWindow>& found) const {
    const XcbReply<xcb_query_tree_reply_t> tree(
        xcb_query_tree_reply(connection(), xcb_query_tree(connection(), window), nullptr));
    if (!tree)
        return;
    const xcb_window_t* const children = xcb_query_tree_children(tree.get());
    for (int i = 0; i < xcb_query_tree_children_length(tree.get()); ++i) {
        if (auto child = described(children[i]))
            found.push_back(std::move(*child));
        else if (depth < deepest_client)
            add_children(children[i], depth + 1, found);
    }
}

std::vector<XWindow> XServer::windows() const {
    std::vector<XWindow> found;
    for (const xcb_window_t window : listed_windows())
        if (auto described_window = described(window))
            found.push_back(std::move(*described_window));
    if (found.empty())
        add_children(root(), 0, found);
    return found;
}

xcb_window_t XServer::top_level_of(xcb_window_t window) const {
    for (;;) {
        const XcbReply<xcb_query_tree_reply_t> tree(
            xcb_query_tree_reply(connection(), xcb_query_tree(connection(), window), nullptr));
        if (!tree)
            return XCB_NONE;
        if (tree->parent == root() || tree->parent == XCB_NONE)
            return window;
        window = tree->parent;
    }
}

std::optional<ScreenArea> XServer::place_on_screen(xcb_window_t window) const {
    const XcbReply<xcb_get_window_attributes_reply_t> attributes(xcb_get_window_attributes_reply(
        connection(), xcb_get_window_attributes(connection(), window), nullptr));
    if (!attributes || attributes->map_state != XCB_MAP_STATE_VIEWABLE)
        return std::nullopt;
    const XcbReply<xcb_get_geometry_reply_t> place(xcb_get_geometry_reply(
        connection(), xcb_get_geometry(connection(), top_level_of(window)), nullptr));
    if (!place)
        return std::nullopt;
    return ScreenArea{
        place->x, place->y,
        Extent{place->width + 2 * place->border_width, place->height + 2 * place->border_width}};
}

XcbReply<xcb_generic_event_t> XServer::wait_for_event(double seconds) const {
    XcbReply<xcb_generic_event_t> event(xcb_poll_for_event(connection()));
    if (event || seconds <= 0.0)
        return event;
    xcb_flush(connection());
    pollfd waiting{xcb_get_file_descriptor(connection()), POLLIN, 0};
    ::poll(&waiting, 1, static_cast<int>(std::ceil(seconds * 1000.0)));
    event.reset(xcb_poll_for_event(connection()));
    return event;
}

void XServer::wait_for_requests() const {
    const XcbReply<xcb_get_input_focus_reply_t> answer(
        xcb_get_input_focus_reply(connection(), xcb_get_input_focus(connection()), nullptr));
}
