#include "lab/media/live_stream.h"

#include "model/picture/encoding_curve.h"

#include <chrono>
#include <utility>

namespace {
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double between_openings = 1.0;  // s
constexpr double longest_wait = 0.1;      // s; the destructor waits for it
}  // namespace

LiveStream::LiveStream(Open open, std::string name, double rate)
    : m_open(std::move(open)), m_name(std::move(name)), m_rate(rate) {
    m_thread = std::thread([this] { run(); });
}

LiveStream::~LiveStream() {
    {
        const std::lock_guard lock(m_mutex);
        m_is_ending = true;
    }
    m_ending.notify_all();
    m_thread.join();
}

SharedPicture LiveStream::newest() const {
    const std::lock_guard lock(m_mutex);
    return m_newest;
}

SharedPicture LiveStream::wait_for_first(double seconds) {
    std::unique_lock lock(m_mutex);
    m_ready.wait_for(lock, Seconds(seconds), [this] { return m_newest || !m_reported.empty(); });
    return m_newest;
}

void LiveStream::wait_until(double seconds) const {
    std::unique_lock lock(m_mutex);
    const auto end = m_begun + std::chrono::duration_cast<Clock::duration>(Seconds(seconds));
    lock.unlock();
    std::this_thread::sleep_until(end);
}

Diagnostics LiveStream::take_problems() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_problems, {});
}

bool LiveStream::take_solved() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_is_solved, false);
}

void LiveStream::report(const std::string& message) {
    {
        const std::lock_guard lock(m_mutex);
        if (std::exchange(m_reported, message) == message)
            return;
        m_is_solved = message.empty();
        if (m_is_solved) {
            m_problems.clear();
            return;
        }
        m_problems.push_back({m_name, 0, message, Severity::warning});
    }
    m_ready.notify_all();
}

void LiveStream::publish(Picture picture) {
    if (const auto encoding = m_encoding.load(); encoding && !picture.bytes)
        recode(picture, *encoding);
    auto shared = std::make_shared<const Picture>(std::move(picture));
    {
        const std::lock_guard lock(m_mutex);
        if (!m_newest)
            m_begun = Clock::now();
        m_newest = std::move(shared);
    }
    m_ready.notify_all();
}

// False: the stream ends.
bool LiveStream::pause(double seconds) {
    std::unique_lock lock(m_mutex);
    return !m_ending.wait_for(lock, Seconds(seconds), [this] { return m_is_ending; });
}

std::unique_ptr<VideoCapture> LiveStream::opened() {
    auto input = m_open();
    if (input)
        return std::move(*input);
    report(input.error().front().message);
    return nullptr;
}

// Resets an input that is lost.
void LiveStream::read(std::unique_ptr<VideoCapture>& input) {
    auto picture = input->read(longest_wait);
    m_asks_user = picture && !*picture && (input->asks_user() || m_asks_user);
    if (!picture) {
        report(picture.error().front().message);
        input.reset();
        return;
    }
    report(input->notice());
    if (*picture)
        publish(std::move(**picture));
}

void LiveStream::run() {
    std::unique_ptr<VideoCapture> input;
    for (;;) {
        const auto start = Clock::now();
        double wait = 0.0;
        if (input) {
            read(input);
            const double rate = m_rate.load();
            wait = rate > 0.0 ? 1.0 / rate - Seconds(Clock::now() - start).count() : 0.0;
        } else {
            input = opened();
        }
        if (!input)
            wait = between_openings;
        if (!pause(std::max(wait, 0.0)))
            return;
    }
}
