#pragma once

#include <cstddef>
#include <functional>
#include <string>

/// Limits of a child process.
struct ChildBounds {
    double seconds = 0.0;
    std::size_t memory_bytes = 0;  // in addition to the program's present use
    std::size_t output_bytes = 0;
};

struct ChildOutput {
    enum class End {
        finished,
        too_slow,          // killed after ChildBounds::seconds
        output_too_large,  // killed
        failed,            // exceeded another limit, crashed or threw an exception
        not_started,
    };

    std::string text;
    End end = End::finished;
    std::string system_error;  // if it was not started
};

/// Runs `work` in a child process and returns its text. A library that needs too much time or
/// memory, or crashes on a file, then affects nothing else. The child's stderr is discarded.
ChildOutput run_bounded(const std::function<std::string()>& work, const ChildBounds& bounds);
