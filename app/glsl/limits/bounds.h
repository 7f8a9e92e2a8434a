#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Why a shader text is rejected before compilation.
struct LimitViolation {
    int line = 1;
    std::string message;
};

/// Finds code that would exhaust a recursive compiler's stack, memory or time: deeply nested
/// brackets, endless statements, macros with exponential expansion. Real shaders stay far below the
/// limits.
std::optional<LimitViolation> find_limit_violation(std::string_view text);
