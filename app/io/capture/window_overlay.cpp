#include "io/capture/window_overlay.h"

#include "io/capture/find_window.h"

#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <xcb/shape.h>
#include <xcb/xfixes.h>

namespace {
constexpr double longest_wait = 0.1;  // s; the destructor waits for it
constexpr double between_searches = 1.0;
constexpr auto between_raises = std::chrono::milliseconds(100);
}  // namespace

class WindowOverlay::Follower {
public:
    Follower(XServer server, xcb_window_t own, std::string title)
        : m_server(std::move(server)), m_own(own), m_title(std::move(title)) {}

    ~Follower() {
        m_is_ending = true;
        if (m_thread.joinable())
            m_thread.join();
    }
    Follower(const Follower&) = delete;
    Follower& operator=(const Follower&) = delete;

    Result<void> start() {
        if (auto found = search(); !found)
            return found;
        make_click_through();
        place();
        m_server.wait_for_requests();
        m_thread = std::thread([this] { run(); });
        return {};
    }

private:
    /// Where a window is, and the child of the root that contains it.
    struct Placed {
        ScreenArea area;  // of the window itself, without the frame of its window manager
        xcb_window_t top_level = XCB_NONE;

        bool operator==(const Placed&) const = default;
    };

    xcb_connection_t* x() const { return m_server.connection(); }

    Result<void> search() {
        auto window = find_window(m_server, m_title);
        if (!window)
            return fail(window.error());
        m_target = window->id;
        listen(m_target, XCB_EVENT_MASK_STRUCTURE_NOTIFY);
        listen(m_server.root(), XCB_EVENT_MASK_SUBSTRUCTURE_NOTIFY);
        return {};
    }

    void listen(xcb_window_t window, std::uint32_t events) const {
        xcb_change_window_attributes(x(), window, XCB_CW_EVENT_MASK, &events);
    }

    // A window manager ignores the window, and an empty input shape lets all clicks through.
    void make_click_through() const {
        constexpr std::uint32_t is_on = 1;
        xcb_change_window_attributes(x(), m_own, XCB_CW_OVERRIDE_REDIRECT, &is_on);
        const xcb_xfixes_region_t nothing = xcb_generate_id(x());
        xcb_xfixes_create_region(x(), nothing, 0, nullptr);
        xcb_xfixes_set_window_shape_region(x(), m_own, XCB_SHAPE_SK_INPUT, 0, 0, nothing);
        xcb_xfixes_destroy_region(x(), nothing);
        xcb_flush(x());
    }

    void run() {
        while (!m_is_ending && !m_server.is_lost()) {
            if (m_target == XCB_NONE) {
                wait(between_searches);
                if (!search())
                    m_target = XCB_NONE;
            }
            place();
            wait(longest_wait);
        }
    }

    // Until something may have changed.
    void wait(double seconds) {
        for (double waited = 0.0; waited < seconds && !m_is_ending; waited += longest_wait)
            if (auto event = m_server.wait_for_event(longest_wait)) {
                for (; event; event = m_server.wait_for_event(0.0))
                    take(*event);
                return;
            }
    }

    void take(const xcb_generic_event_t& event) {
        if (kind_of(event) != XCB_DESTROY_NOTIFY)
            return;
        const auto& gone = reinterpret_cast<const xcb_destroy_notify_event_t&>(event);
        if (gone.window == m_target)
            m_target = XCB_NONE;
    }

    // nullopt: it is not visible.
    std::optional<Placed> placed() {
        const XcbReply<xcb_get_window_attributes_reply_t> attributes(
            xcb_get_window_attributes_reply(x(), xcb_get_window_attributes(x(), m_target),
                                            nullptr));
        if (!attributes)
            m_target = XCB_NONE;  // it was destroyed before its events were asked for
        if (!attributes || attributes->map_state != XCB_MAP_STATE_VIEWABLE)
            return std::nullopt;
        const XcbReply<xcb_get_geometry_reply_t> size(
            xcb_get_geometry_reply(x(), xcb_get_geometry(x(), m_target), nullptr));
        const XcbReply<xcb_translate_coordinates_reply_t> corner(xcb_translate_coordinates_reply(
            x(), xcb_translate_coordinates(x(), m_target, m_server.root(), 0, 0), nullptr));
        const xcb_window_t top_level = m_server.top_level_of(m_target);
        if (!size || !corner || top_level == XCB_NONE)
            return std::nullopt;
        return Placed{{corner->dst_x, corner->dst_y, {size->width, size->height}}, top_level};
    }

    // Whether our window is the next one above.
    bool is_directly_above(xcb_window_t top_level) const {
        const XcbReply<xcb_query_tree_reply_t> tree(
            xcb_query_tree_reply(x(), xcb_query_tree(x(), m_server.root()), nullptr));
        if (!tree)
            return false;
        const xcb_window_t* const windows = xcb_query_tree_children(tree.get());
        const int count = xcb_query_tree_children_length(tree.get());
        for (int i = 0; i + 1 < count; ++i)
            if (windows[i] == top_level)
                return windows[i + 1] == m_own;
        return false;
    }

    // Another program may want the same place, so it is taken a few times per second only.
    bool must_raise(xcb_window_t top_level) {
        const auto now = std::chrono::steady_clock::now();
        if (now - m_raised < between_raises || is_directly_above(top_level))
            return false;
        m_raised = now;
        return true;
    }

    void place() {
        const auto wanted = m_target == XCB_NONE ? std::nullopt : placed();
        if (!wanted) {
            if (m_placed)
                xcb_unmap_window(x(), m_own);
        } else if (wanted != m_placed || must_raise(wanted->top_level)) {
            const ScreenArea& area = wanted->area;
            const std::array values{static_cast<std::uint32_t>(area.x),
                                    static_cast<std::uint32_t>(area.y),
                                    static_cast<std::uint32_t>(area.extent.width),
                                    static_cast<std::uint32_t>(area.extent.height),
                                    wanted->top_level,
                                    static_cast<std::uint32_t>(XCB_STACK_MODE_ABOVE)};
            xcb_configure_window(x(), m_own,
                                 XCB_CONFIG_WINDOW_X | XCB_CONFIG_WINDOW_Y |
                                     XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT |
                                     XCB_CONFIG_WINDOW_SIBLING | XCB_CONFIG_WINDOW_STACK_MODE,
                                 values.data());
            if (!m_placed)
                xcb_map_window(x(), m_own);
        }
        m_placed = wanted;
        xcb_flush(x());
    }

    XServer m_server;
    xcb_window_t m_own;
    std::string m_title;
    xcb_window_t m_target = XCB_NONE;  // none: closed
    std::optional<Placed> m_placed;    // nullopt: ours is hidden
    std::chrono::steady_clock::time_point m_raised;
    std::atomic<bool> m_is_ending = false;
    std::thread m_thread;
};

WindowOverlay::WindowOverlay(std::unique_ptr<Follower> follower)
    : m_follower(std::move(follower)) {}

WindowOverlay::~WindowOverlay() = default;

Result<std::unique_ptr<WindowOverlay>> WindowOverlay::open(std::uint32_t window,
                                                           const std::string& title) {
    auto server = XServer::open({});
    if (!server)
        return fail(server.error());
    auto follower = std::make_unique<Follower>(std::move(*server), window, title);
    if (auto started = follower->start(); !started)
        return fail(started.error());
    return std::unique_ptr<WindowOverlay>(new WindowOverlay(std::move(follower)));
}
