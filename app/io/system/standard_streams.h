#pragma once

/// Descriptors of the program's output and error stream.
constexpr int standard_output = 1;
constexpr int standard_error = 2;

/// Whether a descriptor is a terminal, not a file or pipe.
bool is_terminal(int descriptor);
