#include "lab/storage/waker.h"

#include <array>
#include <poll.h>
#include <unistd.h>

Waker::Waker(int descriptor, std::function<void()> wake) {
    std::array<int, 2> ends{};
    if (descriptor < 0 || pipe(ends.data()) != 0)
        return;
    m_stop_reader = Descriptor(ends[0]);
    m_stop_writer = Descriptor(ends[1]);
    m_thread = std::thread([this, descriptor, wake = std::move(wake)] { run(descriptor, wake); });
}

Waker::~Waker() {
    m_stop_writer = Descriptor();
    if (m_thread.joinable())
        m_thread.join();
}

void Waker::run(int descriptor, const std::function<void()>& wake) const {
    // The main thread reads the data. Until then, polling again would only use CPU time.
    constexpr int patience_ms = 50;
    pollfd stop{m_stop_reader.get(), POLLIN, 0};
    while (true) {
        std::array<pollfd, 2> waited{stop, pollfd{descriptor, POLLIN, 0}};
        if (poll(waited.data(), waited.size(), -1) < 0)
            continue;
        if (waited[0].revents != 0)
            return;
        if (waited[1].revents != 0)
            wake();
        if (poll(&stop, 1, patience_ms) > 0)
            return;
    }
}
