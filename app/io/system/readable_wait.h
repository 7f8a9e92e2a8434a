#pragma once

#include "io/system/descriptor.h"

#include <chrono>

/// Waits on one thread until a descriptor becomes readable; another thread can end the wait.
class ReadableWait {
public:
    explicit ReadableWait(int descriptor);

    /// False for a descriptor of -1, or if the system lacks resources. Then do not wait.
    bool is_possible() const { return m_stop_reader.is_open(); }
    /// Waits until data can be read; false after stop().
    bool wait() const;
    /// Waits for a time; false after stop().
    bool pause(std::chrono::milliseconds time) const;
    /// Ends all waits, also later ones. From any thread.
    void stop() { m_stop_writer = Descriptor(); }

private:
    int m_descriptor;
    Descriptor m_stop_reader;
    Descriptor m_stop_writer;  // closed to end the waits
};
