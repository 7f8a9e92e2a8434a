#pragma once

#include "base/diagnostic.h"

#include <array>
#include <string>
#include <string_view>

/// Limits for a stage, checked before compilation. Compilers and drivers do not limit their own use
/// of memory and time.
struct ShaderLimits {
    double variable_bytes = 1 << 20;  // of all variables; arrays in functions count once per call
    double indexed_bytes = 64 << 10;  // of array variables with a computed index
    double uniforms = 1024;           // each member of structs and blocks counts
    double struct_members = 4096;     // of one struct, including nested members
    double depth = 64;                // of nested structs, and of nested calls
    double instructions = 500'000;    // after inlining of all calls
    double inlined_calls = 24'000;    // including the calls of called functions
    double switch_cases = 1280;       // of one switch
    double compared_values = 4096;    // by == and != of arrays and structs, after inlining

    bool operator==(const ShaderLimits&) const = default;
};

/// A limit and its name for --limit.
struct ShaderLimit {
    std::string_view name;
    double ShaderLimits::*value;
    std::string_view about;  // what it counts, for the help text
};

inline constexpr std::array shader_limits{
    ShaderLimit{"variable-bytes", &ShaderLimits::variable_bytes, "bytes of variables"},
    ShaderLimit{"indexed-bytes", &ShaderLimits::indexed_bytes,
                "bytes of arrays with a computed index"},
    ShaderLimit{"uniforms", &ShaderLimits::uniforms,
                "uniforms (members of uniform structs included)"},
    ShaderLimit{"struct-members", &ShaderLimits::struct_members, "members in one struct"},
    ShaderLimit{"depth", &ShaderLimits::depth, "levels of nested structs or calls"},
    ShaderLimit{"instructions", &ShaderLimits::instructions, "instructions after inlining"},
    ShaderLimit{"inlined-calls", &ShaderLimits::inlined_calls, "calls after inlining"},
    ShaderLimit{"switch-cases", &ShaderLimits::switch_cases, "cases in one switch"},
    ShaderLimit{"compared-values", &ShaderLimits::compared_values,
                "compared values in arrays and structs"},
};

/// Sets the limit in "NAME=VALUE"; VALUE is an integer from 1 to 1e12. An error lists the names of
/// all limits.
Result<void> set_limit(ShaderLimits& limits, std::string_view text);

/// All values on one line, in the order of `shader_limits`.
std::string to_string(const ShaderLimits& limits);
