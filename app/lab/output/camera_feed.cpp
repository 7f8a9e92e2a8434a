#include "lab/output/camera_feed.h"

#include "io/video/frame_bytes.h"

#include <algorithm>
#include <chrono>
#include <utility>

CameraFeed::CameraFeed(std::unique_ptr<VirtualCamera> camera, double rate,
                       std::function<void()> wake)
    : m_camera(std::move(camera)), m_rate(rate), m_wake(std::move(wake)) {
    m_thread = std::thread([this] { run(); });
}

CameraFeed::~CameraFeed() {
    {
        const std::lock_guard lock(m_mutex);
        m_is_ending = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

bool CameraFeed::is_watched() const {
    const std::lock_guard lock(m_mutex);
    return m_is_watched;
}

bool CameraFeed::needs_picture() const {
    const std::lock_guard lock(m_mutex);
    return m_is_watched && !m_has_picture;
}

std::string CameraFeed::problem() const {
    const std::lock_guard lock(m_mutex);
    return m_problem;
}

void CameraFeed::show(RawPicture picture) {
    {
        const std::lock_guard lock(m_mutex);
        if (!m_is_watched)
            return;  // the reader has left since
        m_next = std::move(picture);
        m_has_picture = true;
    }
}

void CameraFeed::run() {
    using Clock = std::chrono::steady_clock;
    const auto between =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / m_rate));
    auto due = Clock::now();
    std::string rgb;
    std::unique_lock lock(m_mutex);
    while (!m_is_ending) {
        due = std::max(due + between, Clock::now());  // a late picture does not hurry the next
        if (m_changed.wait_until(lock, due, [this] { return m_is_ending; }))
            return;
        const auto next = std::exchange(m_next, std::nullopt);
        lock.unlock();
        if (next)
            rgb = frame_bytes(*next, 8, FrameAlpha::none);
        auto shown = rgb.empty() ? Result<void>() : m_camera->show(rgb);
        const auto is_watched = m_camera->is_watched();
        if (shown && !is_watched)
            shown = fail(is_watched.error());
        lock.lock();
        if (!shown) {
            m_problem = shown.error().front().message;
            return m_wake();
        }
        const bool was_watched = std::exchange(m_is_watched, *is_watched);
        if (was_watched == *is_watched)
            continue;
        if (was_watched) {  // the next reader must not see an old picture
            std::ranges::fill(rgb, '\0');
            m_next.reset();
            m_has_picture = false;
        }
        m_wake();
    }
}
