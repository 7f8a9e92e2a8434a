#pragma once

#include "io/system/readable_wait.h"

#include <functional>
#include <thread>

/// A thread that wakes a waiting window when a descriptor becomes readable.
class EventWaker {
public:
    /// `wake` is called on the waker's thread. Does nothing for a descriptor of -1.
    EventWaker(int descriptor, std::function<void()> wake);
    ~EventWaker();
    EventWaker(const EventWaker&) = delete;
    EventWaker& operator=(const EventWaker&) = delete;

private:
    ReadableWait m_wait;
    std::thread m_thread;
};
