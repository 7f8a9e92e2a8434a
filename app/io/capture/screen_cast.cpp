#include "io/capture/screen_cast.h"

#include "io/capture/screen_cast_session.h"
#include "io/pipewire/pipewire_video.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace {
using Seconds = std::chrono::duration<double>;

/// What the user has answered, for all captures of this process.
struct Answer {
    std::mutex mutex;
    std::string permission;  // to share the same again; "": none
    bool is_denied = false;
};

Answer& answer() {
    static Answer given;
    return given;
}

/// The newest picture of a PipeWire stream.
class NewestPicture {
public:
    /// On the thread of the stream.
    void take(const PipeWirePixels& pixels) {
        const std::size_t row = static_cast<std::size_t>(pixels.extent.width) * 4;
        const auto rows = static_cast<std::size_t>(pixels.extent.height);
        const std::shared_ptr<std::uint8_t> bytes(new std::uint8_t[row * rows],
                                                  std::default_delete<std::uint8_t[]>());
        for (std::size_t y = 0; y < rows; ++y)
            copy_row(pixels, y, row, bytes.get() + y * row);
        {
            const std::lock_guard lock(m_mutex);
            m_picture = Picture{pixels.extent, 4, Encoding::display, {}, {}, {}, bytes};
        }
        m_arrived.notify_all();
    }

    std::optional<Picture> wait(double seconds) {
        std::unique_lock lock(m_mutex);
        m_arrived.wait_for(lock, Seconds(seconds), [this] { return m_picture.has_value(); });
        return std::exchange(m_picture, std::nullopt);
    }

private:
    static void copy_row(const PipeWirePixels& pixels, std::size_t y, std::size_t row,
                         std::uint8_t* to) {
        const std::uint8_t* const from = pixels.bytes.data() + y * pixels.stride;
        std::memcpy(to, from, row);
        for (std::size_t x = 0; pixels.is_rgb && x < row; x += 4)
            std::swap(to[x], to[x + 2]);
    }

    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::optional<Picture> m_picture;
};

class ScreenCast final : public VideoCapture {
public:
    explicit ScreenCast(std::unique_ptr<ScreenCastSession> session)
        : m_session(std::move(session)) {}

    Result<std::optional<Picture>> read(double seconds) override {
        if (!m_video)
            return begin(seconds);
        if (auto checked = m_session->check(); !checked)
            return failed(checked.error());
        if (const std::string problem = m_video->problem(); !problem.empty())
            return fail({{}, 0, problem});
        return m_newest.wait(seconds);
    }

    bool asks_user() const override { return !m_video; }

private:
    tl::unexpected<Diagnostics> failed(const Diagnostics& why) const {
        const std::lock_guard lock(answer().mutex);
        answer().is_denied = answer().is_denied || m_session->is_denied();
        return fail(why);
    }

    Result<std::optional<Picture>> begin(double seconds) {
        auto stream = m_session->wait(seconds);
        if (!stream)
            return failed(stream.error());
        if (!*stream)
            return std::nullopt;
        {
            const std::lock_guard lock(answer().mutex);
            answer().permission = (*stream)->permission;
        }
        auto video =
            PipeWireVideo::read((*stream)->socket, (*stream)->node,
                                [this](const PipeWirePixels& pixels) { m_newest.take(pixels); });
        if (!video)
            return fail(video.error());
        m_video = std::move(*video);
        return std::nullopt;
    }

    std::unique_ptr<ScreenCastSession> m_session;
    NewestPicture m_newest;
    std::unique_ptr<PipeWireVideo> m_video;  // null: the user has not chosen yet. It calls m_newest
};
}  // namespace

bool has_screen_cast() {
    const char* const display = std::getenv("WAYLAND_DISPLAY");
    return display && *display;
}

void allow_screen_cast_question() {
    const std::lock_guard lock(answer().mutex);
    answer().is_denied = false;
}

Result<std::unique_ptr<VideoCapture>> cast_screen(const LiveSpec& spec) {
    if (spec.area)
        return fail({{},
                     0,
                     "area= needs an X11 session. Leave it out, and choose a screen or a window in "
                     "the dialog of the desktop."});
    std::string permission;
    {
        const std::lock_guard lock(answer().mutex);
        if (answer().is_denied)
            return fail({{}, 0, screen_cast_refused});
        permission = answer().permission;
    }
    auto session = ScreenCastSession::open(spec.has_cursor, std::move(permission));
    if (!session)
        return fail(session.error());
    return std::make_unique<ScreenCast>(std::move(*session));
}
