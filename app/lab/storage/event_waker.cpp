#include "lab/storage/event_waker.h"

EventWaker::EventWaker(int descriptor, std::function<void()> wake) : m_wait(descriptor) {
    if (!m_wait.is_possible())
        return;
    // The main thread reads the data. Until then, waiting again would only use CPU time.
    static constexpr std::chrono::milliseconds timeout{50};
    m_thread = std::thread([this, wake = std::move(wake)] {
        while (m_wait.wait()) {
            wake();
            if (!m_wait.pause(timeout))
                return;
        }
    });
}

EventWaker::~EventWaker() {
    m_wait.stop();
    if (m_thread.joinable())
        m_thread.join();
}
