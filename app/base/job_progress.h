#pragma once

#include <atomic>

/// Progress and cancellation of long work on another thread. Shared by both threads.
struct JobProgress {
    std::atomic<double> share = 0.0;  // done, 0..1; an estimate
    std::atomic<bool> is_cancelled = false;
};
