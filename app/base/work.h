#pragma once

#include <atomic>

/// What long work on another thread says of itself, and how it is stopped. Shared by both threads.
struct Work {
    std::atomic<double> share = 0.0;  // done so far, 0..1; an estimate
    std::atomic<bool> is_cancelled = false;
};
