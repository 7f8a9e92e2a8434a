#pragma once

#include "base/diagnostic.h"

#include <array>
#include <string>
#include <string_view>

/// What a stage may have before it is given to a compiler. Compilers and drivers take memory and
/// time without a bound of their own.
struct ShaderLimits {
    double variable_bytes = 1 << 20;  // of all variables, arrays of functions once a call
    double indexed_bytes = 64 << 10;  // of variables that are arrays with a computed index
    double uniforms = 1024;           // members of structs and blocks count one each
    double struct_members = 4096;     // of one struct, members of its members included
    double depth = 64;                // of structs in structs, and of calls in calls
    double instructions = 500'000;    // with every call inlined
    double inlined_calls = 24'000;    // calls, those of called functions included
    double switch_cases = 1280;       // of one switch
    double compared_values = 4096;    // by == and != of arrays and structs, with calls inlined

    bool operator==(const ShaderLimits&) const = default;
};

/// A limit by the name that --limit takes.
struct ShaderLimit {
    std::string_view name;
    double ShaderLimits::*value;
    std::string_view about;  // what it counts, for the help
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

/// Sets the limit that "NAME=VALUE" names; VALUE is a whole number from 1 to 1e12. An error names
/// the limits that exist.
Result<void> set_limit(ShaderLimits& limits, std::string_view text);

/// All values in one line, in the order of `shader_limits`.
std::string to_string(const ShaderLimits& limits);
