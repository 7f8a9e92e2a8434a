#pragma once

#include "model/look/shader_limits.h"

#include <optional>
#include <string>

namespace glslang {
class TShader;
}

/// The estimated cost of compiling a stage in a driver, from glslang's tree, with the most
/// expensive lines.
struct StageCost {
    /// A figure and the line that causes it; 0: the whole stage.
    struct Figure {
        double value = 0.0;
        int line = 0;

        /// Sets the figure to the larger value.
        void raise(double other, int at) {
            if (other > value)
                *this = {other, at};
        }
    };

    Figure variable_bytes;   // including globals, uniforms and parameters; arrays once per call
    Figure indexed_bytes;    // local and global variables only
    Figure uniforms;         // names listed by a driver, one per struct member
    Figure depth;            // nesting of structs or calls, whichever is larger
    Figure instructions;     // with all calls inlined; copies of arrays count per element
    Figure inlined_calls;    // of a function, including nested calls
    Figure switch_cases;     // of the largest switch
    Figure compared_values;  // by == and != of arrays and structs, with all calls inlined
};

/// Estimates a shader that was parsed without errors. The shader and its memory pool must still
/// exist. Functions that main does not reach count as well: each figure is the maximum of all
/// functions.
StageCost estimate_cost(glslang::TShader& shader);

/// The figure that exceeds a limit, and that limit.
struct ExceededLimit {
    double ShaderLimits::*limit = nullptr;
    StageCost::Figure figure;
};

/// The first limit that a cost exceeds; nullopt: within all limits.
std::optional<ExceededLimit> find_exceeded(const StageCost& cost, const ShaderLimits& limits);

/// The error message for an exceeded limit: the figure, the limit, and how to raise it.
std::string refusal(const ExceededLimit& exceeded, const ShaderLimits& limits);
