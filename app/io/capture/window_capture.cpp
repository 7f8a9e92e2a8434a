#include "io/capture/window_capture.h"

#include "io/capture/drawable_reader.h"
#include "io/capture/find_window.h"
#include "io/capture/screen_cast.h"
#include "io/capture/x_damage.h"
#include "io/capture/x_server.h"

#include <fmt/format.h>

#include <chrono>
#include <xcb/composite.h>

namespace {
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// The server keeps the pixels of a redirected window in a pixmap of its own.
class WindowCapture final : public VideoCapture {
public:
    WindowCapture(XServer server, XWindow window)
        : m_server(std::move(server)),
          m_window(std::move(window)),
          m_damage(m_server, m_window.id) {
        constexpr std::uint32_t events = XCB_EVENT_MASK_STRUCTURE_NOTIFY;
        xcb_change_window_attributes(m_server.connection(), m_window.id, XCB_CW_EVENT_MASK,
                                     &events);
        xcb_composite_redirect_window(m_server.connection(), m_window.id,
                                      XCB_COMPOSITE_REDIRECT_AUTOMATIC);
    }

    Result<std::optional<Picture>> read(double seconds) override {
        const auto end = Clock::now() + Seconds(seconds);
        for (;;) {
            take_events(0.0);
            if (m_is_closed)
                return fail({{}, 0, fmt::format("the window '{}' was closed", m_window.title)});
            if (m_server.is_lost())
                return fail({{}, 0, "the X server has ended the connection"});
            if (m_needs_pixmap && !m_is_hidden && !renew_pixmap()) {
                m_is_hidden = true;  // until it is mapped
                continue;
            }
            const double repaints = Seconds(m_repainted - Clock::now()).count();
            if (repaints > 0.0) {
                take_events(repaints);
                continue;
            }
            if (!m_is_hidden && (!m_damage.is_empty() || m_needs_all)) {
                auto read = update();
                if (!read)
                    return fail(read.error());
                if (*read)
                    return Picture{m_reader->extent(), 4, Encoding::display, {}, {}, {},
                                   m_reader->bytes()};
            }
            const double left = Seconds(end - Clock::now()).count();
            if (left <= 0.0)
                return std::nullopt;
            take_events(left);
        }
    }

    std::string notice() const override {
        return m_is_hidden
                   ? fmt::format(
                         "the window '{}' is minimised, so its last picture stays. Restore it.",
                         m_window.title)
                   : std::string();
    }

private:
    void take_events(double seconds) {
        for (auto event = m_server.wait_for_event(seconds); event;
             event = m_server.wait_for_event(0.0))
            take(*event);
    }

    void take(const xcb_generic_event_t& event) {
        if (m_damage.add(event))
            return;
        switch (kind_of(event)) {
            case XCB_CONFIGURE_NOTIFY: {
                const auto& moved = reinterpret_cast<const xcb_configure_notify_event_t&>(event);
                const Extent extent{moved.width, moved.height};
                m_needs_pixmap = m_needs_pixmap || !m_reader || m_reader->extent() != extent;
                break;
            }
            case XCB_MAP_NOTIFY:
                m_is_hidden = false;
                m_needs_pixmap = true;
                break;
            case XCB_UNMAP_NOTIFY:
                m_is_hidden = true;
                break;
            case XCB_DESTROY_NOTIFY:
                m_is_closed = true;
                break;
            default:
                break;
        }
    }

    // The pixmap has the size that the window had when it was named. False: the window is hidden.
    bool renew_pixmap() {
        xcb_connection_t* const connection = m_server.connection();
        if (m_pixmap != XCB_NONE)
            xcb_free_pixmap(connection, m_pixmap);
        m_pixmap = xcb_generate_id(connection);
        const XcbReply<xcb_generic_error_t> refusal(xcb_request_check(
            connection,
            xcb_composite_name_window_pixmap_checked(connection, m_window.id, m_pixmap)));
        const XcbReply<xcb_get_geometry_reply_t> size(
            refusal ? nullptr
                    : xcb_get_geometry_reply(connection, xcb_get_geometry(connection, m_pixmap),
                                             nullptr));
        if (!size) {
            m_pixmap = XCB_NONE;
            const XcbReply<xcb_get_geometry_reply_t> window(xcb_get_geometry_reply(
                connection, xcb_get_geometry(connection, m_window.id), nullptr));
            m_is_closed = !window;
            return false;
        }
        const Extent extent{size->width, size->height};
        if (!m_reader || m_reader->extent() != extent)
            m_reader = std::make_unique<DrawableReader>(m_server, extent);
        m_needs_pixmap = false;
        m_needs_all = true;
        return true;
    }

    // False: the window changes its size just now.
    Result<bool> update() {
        m_damage.take();
        auto read = m_reader->read(m_pixmap, 0, 0);
        if (read && *read)
            m_needs_all = false;
        else if (read)
            m_needs_pixmap = true;
        return read;
    }

    XServer m_server;
    XWindow m_window;
    XDamage m_damage;
    std::unique_ptr<DrawableReader> m_reader;
    xcb_pixmap_t m_pixmap = XCB_NONE;
    // The first pixmap has other windows where they cover this one, until the program repaints.
    Clock::time_point m_repainted = Clock::now() + std::chrono::milliseconds(100);
    bool m_needs_pixmap = true;
    bool m_needs_all = true;
    bool m_is_hidden = false;
    bool m_is_closed = false;
};
}  // namespace

Result<std::unique_ptr<VideoCapture>> capture_window(const std::string& title) {
    auto server = XServer::open({});
    if (!server)
        return fail(server.error());
    auto window = find_window(*server, title);
    if (!window)
        return fail(
            {{},
             0,
             window.error().front().message +
                 (has_screen_cast() ? ". On Wayland, use screen: to choose other windows." : "")});
    return std::make_unique<WindowCapture>(std::move(*server), std::move(*window));
}
