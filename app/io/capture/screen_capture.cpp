#include "io/capture/screen_capture.h"

#include "io/capture/drawable_reader.h"
#include "io/capture/x_damage.h"
#include "io/capture/x_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <xcb/xfixes.h>

namespace {
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds own_windows_stay{0.5};        // how long a list of our windows is used
constexpr double cursor_interval = 1.0 / 60.0;  // s; its movement damages nothing

/// The mouse cursor, px from the top left of the screen.
struct Cursor {
    ScreenArea place;
    std::vector<std::uint32_t> pixels;  // premultiplied ARGB

    bool operator==(const Cursor&) const = default;
};

class ScreenCapture final : public VideoCapture {
public:
    ScreenCapture(XServer server, const ScreenArea& area, bool has_cursor)
        : m_server(std::move(server)),
          m_area(area),
          m_has_cursor(has_cursor),
          m_damage(m_server, m_server.root()),
          m_reader(m_server, area.extent) {
        m_damage.add(area);
    }

    Result<std::optional<Picture>> read(double seconds) override {
        const auto end = Clock::now() + Seconds(seconds);
        for (;;) {
            take_events(0.0);
            if (m_server.is_lost())
                return fail({{}, 0, "the X server has ended the connection"});
            auto changed = update();
            if (!changed)
                return fail(changed.error());
            if (*changed)
                return picture();
            const double left = Seconds(end - Clock::now()).count();
            if (left <= 0.0)
                return std::nullopt;
            take_events(m_has_cursor ? std::min(left, cursor_interval) : left);
        }
    }

    std::string notice() const override {
        return m_covered.empty() ? std::string()
                                 : "the window of Afterglow covers a part of the source, which "
                                   "stays as it was. Move the window, or choose an area.";
    }

private:
    void take_events(double seconds) {
        for (auto event = m_server.wait_for_event(seconds); event;
             event = m_server.wait_for_event(0.0))
            m_damage.add(*event);
    }

    Result<bool> update() {
        const bool has_moved = m_has_cursor && update_cursor();
        if (m_damage.is_empty() && !has_moved)
            return false;
        find_own_windows();
        const auto damaged = m_damage.take();
        const auto part = damaged ? overlap_of(*damaged, m_area) : std::nullopt;
        if (!has_moved && (!part || is_covered(*part)))
            return false;
        auto read = m_reader.read(m_server.root(), m_area.x, m_area.y, m_covered);
        if (read && !*read)
            return fail({{}, 0, "the screen's size has changed"});
        return read;
    }

    bool update_cursor() {
        const XcbReply<xcb_xfixes_get_cursor_image_reply_t> reply(xcb_xfixes_get_cursor_image_reply(
            m_server.connection(), xcb_xfixes_get_cursor_image(m_server.connection()), nullptr));
        if (!reply)
            return false;
        const std::uint32_t* const pixels = xcb_xfixes_get_cursor_image_cursor_image(reply.get());
        const int count = xcb_xfixes_get_cursor_image_cursor_image_length(reply.get());
        Cursor cursor{
            {reply->x - reply->xhot, reply->y - reply->yhot, {reply->width, reply->height}},
            {pixels, pixels + count}};
        if (cursor == m_cursor)
            return false;
        m_cursor = std::move(cursor);
        return true;
    }

    // Where our windows lie in the area. What they uncover is damaged.
    void find_own_windows() {
        if (Clock::now() - m_listed > own_windows_stay) {
            m_own.clear();
            for (const XWindow& window : m_server.windows())
                if (window.is_own)
                    m_own.push_back(window.id);
            m_listed = Clock::now();
        }
        m_covered.clear();
        for (const xcb_window_t window : m_own)
            if (const auto place = m_server.place_on_screen(window))
                if (const auto part = overlap_of(*place, m_area))
                    m_covered.push_back({part->x - m_area.x, part->y - m_area.y, part->extent});
    }

    // Only our own window was drawn.
    bool is_covered(const ScreenArea& part) const {
        const ScreenArea here{part.x - m_area.x, part.y - m_area.y, part.extent};
        return std::ranges::any_of(m_covered, [&](const ScreenArea& covered) {
            return overlap_of(here, covered) == here;
        });
    }

    Picture picture() const {
        if (const auto part = m_has_cursor ? overlap_of(m_cursor.place, m_area) : std::nullopt)
            draw_cursor(*part);
        return {m_area.extent, 4, Encoding::display, {}, {}, {}, m_reader.bytes()};
    }

    void draw_cursor(const ScreenArea& part) const {
        for (int y = part.y; y < part.y + part.extent.height; ++y)
            for (int x = part.x; x < part.x + part.extent.width; ++x) {
                const auto row = static_cast<std::size_t>(y - m_cursor.place.y);
                const auto column = static_cast<std::size_t>(x - m_cursor.place.x);
                const auto width = static_cast<std::size_t>(m_cursor.place.extent.width);
                const std::size_t pixel = static_cast<std::size_t>(y - m_area.y) *
                                              static_cast<std::size_t>(m_area.extent.width) +
                                          static_cast<std::size_t>(x - m_area.x);
                blend(m_cursor.pixels[row * width + column], m_reader.bytes().get() + 4 * pixel);
            }
    }

    // `argb` is premultiplied; the pixel is blue, green, red.
    static void blend(std::uint32_t argb, std::uint8_t* pixel) {
        const std::uint32_t alpha = argb >> 24U;
        for (unsigned c = 0; c < 3; ++c) {
            const std::uint32_t own = (argb >> (8U * c)) & 0xFFU;
            const std::uint32_t below = (pixel[c] * (255U - alpha) + 127U) / 255U;
            pixel[c] = static_cast<std::uint8_t>(std::min(own + below, 255U));
        }
    }

    XServer m_server;
    ScreenArea m_area;
    bool m_has_cursor;
    XDamage m_damage;
    DrawableReader m_reader;
    Cursor m_cursor;
    std::vector<xcb_window_t> m_own;  // our windows
    Clock::time_point m_listed;
    std::vector<ScreenArea> m_covered;  // by our windows, px of the picture
};
}  // namespace

Result<std::unique_ptr<VideoCapture>> capture_screen(const LiveSpec& spec) {
    auto server = XServer::open(spec.name);
    if (!server)
        return fail(server.error());
    const ScreenArea all{0, 0, server->extent()};
    const ScreenArea area = spec.area.value_or(all);
    if (overlap_of(area, all) != area)
        return fail({{},
                     0,
                     fmt::format("the area does not fit on the screen, which has {}x{} px",
                                 all.extent.width, all.extent.height)});
    return std::make_unique<ScreenCapture>(std::move(*server), area, spec.has_cursor);
}
