#pragma once

#include "io/files/descriptor.h"

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
    void run(int descriptor, const std::function<void()>& wake) const;

    Descriptor m_stop_reader;
    Descriptor m_stop_writer;  // closed to end the thread
    std::thread m_thread;
};
