#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Why a text is not handed to the compiler.
struct OutOfBounds {
    int line = 1;
    std::string message;
};

/// Finds what would make a recursive compiler run out of stack, memory or patience: brackets nested
/// too deeply, endless statements, macros that multiply. Shaders for a picture stay far below.
std::optional<OutOfBounds> find_out_of_bounds(std::string_view text);
