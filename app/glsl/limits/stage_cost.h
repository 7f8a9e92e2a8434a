#pragma once

#include "model/look/shader_limits.h"

#include <optional>
#include <string>

namespace glslang {
class TShader;
}

/// What a driver has to compile of one stage, estimated from glslang's tree, and the lines that
/// matter most.
struct StageCost {
    /// A figure, and the line of the text to blame; 0: the whole stage.
    struct Figure {
        double value = 0.0;
        int line = 0;

        /// Becomes the larger one.
        void raise(double other, int at) {
            if (other > value)
                *this = {other, at};
        }
    };

    Figure variable_bytes;   // globals, uniforms and parameters included; arrays once a call
    Figure indexed_bytes;    // variables of functions and globals alone
    Figure uniforms;         // names that a driver lists: struct members one each
    Figure depth;            // the deepest struct or chain of calls
    Figure instructions;     // operations with every call inlined; copies of arrays by element
    Figure inlined_calls;    // of a function, those of called functions included
    Figure switch_cases;     // of the largest switch
    Figure compared_values;  // by == and != of arrays and structs, with every call inlined
};

/// Estimates a shader that was parsed without errors, while it and its memory live. Functions that
/// main does not reach count as well: the largest of all is meant.
StageCost estimate_cost(glslang::TShader& shader);

/// A limit that a stage exceeds, and by which figure.
struct ExceededLimit {
    double ShaderLimits::*limit = nullptr;
    StageCost::Figure figure;
};

/// The first limit that a cost exceeds; none: it is within all of them.
std::optional<ExceededLimit> find_exceeded(const StageCost& cost, const ShaderLimits& limits);

/// The message about an exceeded limit: the figure, the limit, and how to raise it.
std::string refusal(const ExceededLimit& exceeded, const ShaderLimits& limits);
