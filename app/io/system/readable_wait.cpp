#include "io/system/readable_wait.h"

#include <array>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

ReadableWait::ReadableWait(int descriptor) : m_descriptor(descriptor) {
    std::array<int, 2> ends{};
    if (descriptor < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0)
        return;
    m_stop_reader = Descriptor(ends[0]);
    m_stop_writer = Descriptor(ends[1]);
}

bool ReadableWait::wait() const {
    std::array<pollfd, 2> waited{pollfd{m_stop_reader.get(), POLLIN, 0},
                                 pollfd{m_descriptor, POLLIN, 0}};
    while (::poll(waited.data(), waited.size(), -1) < 0) {
    }
    return waited[0].revents == 0;
}

bool ReadableWait::pause(std::chrono::milliseconds time) const {
    pollfd stop{m_stop_reader.get(), POLLIN, 0};
    return ::poll(&stop, 1, static_cast<int>(time.count())) <= 0;
}
