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
    std::string text;
    std::string problem;  // "": success
};

/// Runs `work` in a child process and returns its text. A library that needs too much time or
/// memory, or crashes on a file, then affects nothing else. `problem` has the exceeded limit.
ChildOutput run_bounded(const std::function<std::string()>& work, const ChildBounds& bounds);
