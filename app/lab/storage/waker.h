#pragma once

#include "io/system/readable_wait.h"

#include <functional>
#include <thread>

/// A thread that wakes a waiting window when a descriptor becomes readable.
class Waker {
public:
    /// `wake` is called on the waker's thread. Does nothing for a descriptor of -1.
    Waker(int descriptor, std::function<void()> wake);
    ~Waker();
    Waker(const Waker&) = delete;
    Waker& operator=(const Waker&) = delete;

private:
    ReadableWait m_wait;
    std::thread m_thread;
};
