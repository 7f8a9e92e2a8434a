#pragma once

#include <cstddef>
#include <functional>
#include <string>

/// What a piece of work may take.
struct ChildBounds {
    double seconds = 0.0;
    std::size_t memory_bytes = 0;  // besides what the program has already
    std::size_t output_bytes = 0;
};

struct ChildOutput {
    std::string text;
    std::string problem;  // "": the work was done
};

/// Does the work in a child process and gives its text: a library that takes too long, takes too
/// much memory or crashes on a file then ends nothing else. `problem` says which bound was met.
ChildOutput run_bounded(const std::function<std::string()>& work, const ChildBounds& bounds);
