// An X11 window that paints itself as its standard input says, one command per line:
//   fill RRGGBB | part X Y W H RRGGBB | move X Y | resize W H | hide | show | lower | raise
// It paints again what was uncovered, and answers "done" when the server has carried out a command.
// Its arguments are TITLE X Y W H.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <poll.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>
#include <xcb/xcb.h>

namespace {
constexpr int largest_side = 8192;

struct Place {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// A window without border or window manager.
class PaintedWindow {
public:
    PaintedWindow(xcb_connection_t* connection, const std::string& title, const Place& place)
        : m_connection(connection),
          m_screen(xcb_setup_roots_iterator(xcb_get_setup(connection)).data),
          m_window(xcb_generate_id(connection)),
          m_context(xcb_generate_id(connection)) {
        const std::uint32_t exposure = XCB_EVENT_MASK_EXPOSURE;
        xcb_create_window(
            m_connection, XCB_COPY_FROM_PARENT, m_window, m_screen->root,
            static_cast<std::int16_t>(place.x), static_cast<std::int16_t>(place.y),
            static_cast<std::uint16_t>(place.width), static_cast<std::uint16_t>(place.height), 0,
            XCB_WINDOW_CLASS_INPUT_OUTPUT, m_screen->root_visual, XCB_CW_EVENT_MASK, &exposure);
        xcb_change_property(m_connection, XCB_PROP_MODE_REPLACE, m_window, XCB_ATOM_WM_NAME,
                            XCB_ATOM_STRING, 8, static_cast<std::uint32_t>(title.size()),
                            title.c_str());
        xcb_create_gc(m_connection, m_context, m_window, 0, nullptr);
        xcb_map_window(m_connection, m_window);
        synchronize();
    }

    /// Paints again after the server has uncovered parts.
    void repaint() {
        while (is_uncovered()) {
            const std::vector<std::string> painted = std::exchange(m_painted, {});
            for (const std::string& line : painted)
                obey(line);
        }
    }

    /// False: the command is unknown.
    bool obey(const std::string& line) {
        std::istringstream words(line);
        std::string command;
        words >> command;
        Place place;
        if (command == "fill")
            m_painted.clear();
        if (command == "fill" || command == "part")
            m_painted.push_back(line);
        if (command == "fill")
            paint({0, 0, largest_side, largest_side}, words);
        else if (command == "part" && words >> place.x >> place.y >> place.width >> place.height)
            paint(place, words);
        else if (command == "move" && words >> place.x >> place.y)
            configure(XCB_CONFIG_WINDOW_X | XCB_CONFIG_WINDOW_Y, place.x, place.y);
        else if (command == "resize" && words >> place.width >> place.height)
            configure(XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT, place.width,
                      place.height);
        else if (command == "lower")
            stack(XCB_STACK_MODE_BELOW);
        else if (command == "raise")
            stack(XCB_STACK_MODE_ABOVE);
        else if (command == "hide")
            xcb_unmap_window(m_connection, m_window);
        else if (command == "show")
            xcb_map_window(m_connection, m_window);
        else
            return false;
        synchronize();
        return true;
    }

private:
    // Takes all events, also those that came with the answer to another request.
    bool is_uncovered() {
        bool is_exposed = false;
        while (xcb_generic_event_t* const event = xcb_poll_for_event(m_connection)) {
            is_exposed = is_exposed || event->response_type == XCB_EXPOSE;
            std::free(event);
        }
        return is_exposed;
    }

    void paint(const Place& place, std::istringstream& words) {
        std::string color;
        words >> color;
        const auto pixel = static_cast<std::uint32_t>(std::stoul(color, nullptr, 16));
        xcb_change_gc(m_connection, m_context, XCB_GC_FOREGROUND, &pixel);
        const xcb_rectangle_t area{
            static_cast<std::int16_t>(place.x), static_cast<std::int16_t>(place.y),
            static_cast<std::uint16_t>(place.width), static_cast<std::uint16_t>(place.height)};
        xcb_poly_fill_rectangle(m_connection, m_window, m_context, 1, &area);
    }

    void configure(std::uint16_t mask, int first, int second) {
        const std::uint32_t values[]{static_cast<std::uint32_t>(first),
                                     static_cast<std::uint32_t>(second)};
        xcb_configure_window(m_connection, m_window, mask, values);
    }

    // Below or above all other windows.
    void stack(std::uint32_t mode) {
        xcb_configure_window(m_connection, m_window, XCB_CONFIG_WINDOW_STACK_MODE, &mode);
    }

    void synchronize() {
        std::free(
            xcb_get_input_focus_reply(m_connection, xcb_get_input_focus(m_connection), nullptr));
    }

    xcb_connection_t* m_connection;
    xcb_screen_t* m_screen;
    xcb_window_t m_window;
    xcb_gcontext_t m_context;
    std::vector<std::string> m_painted;  // commands
};
}  // namespace

int main(int count, char** words) {
    if (count != 6) {
        std::fprintf(stderr, "usage: painted_window TITLE X Y W H\n");
        return 2;
    }
    xcb_connection_t* const connection = xcb_connect(nullptr, nullptr);
    if (xcb_connection_has_error(connection) != 0) {
        std::fprintf(stderr, "there is no X display\n");
        return 1;
    }
    PaintedWindow window(
        connection, words[1],
        {std::atoi(words[2]), std::atoi(words[3]), std::atoi(words[4]), std::atoi(words[5])});
    std::cout << "done" << std::endl;
    std::string unread;
    for (;;) {
        pollfd waited[]{{STDIN_FILENO, POLLIN, 0},
                        {xcb_get_file_descriptor(connection), POLLIN, 0}};
        window.repaint();  // poll() does not see events that were already read
        poll(waited, 2, -1);
        if (waited[0].revents == 0)
            continue;
        char bytes[256];
        const ssize_t size = read(STDIN_FILENO, bytes, sizeof bytes);
        if (size <= 0)
            break;
        unread.append(bytes, static_cast<std::size_t>(size));
        for (std::size_t end = unread.find('\n'); end != std::string::npos;
             end = unread.find('\n')) {
            std::cout << (window.obey(unread.substr(0, end)) ? "done" : "unknown command")
                      << std::endl;
            unread.erase(0, end + 1);
        }
    }
    xcb_disconnect(connection);
    return 0;
}
