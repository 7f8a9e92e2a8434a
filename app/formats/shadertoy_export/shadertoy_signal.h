#pragma once

#include "base/diagnostic.h"
#include "model/look/spec.h"

#include <string>

/// A signal as GLSL.
struct ShadertoySignal {
    /// Its settings as constants with annotations, and two functions. Times are in 1/60 s.
    /// vec3 signal_point(vec4 start, float time, float step): x, y and current of a point, for the
    /// state at the frame's start and the time since then. `step` is the time between two points.
    /// vec4 signal_state(vec4 start, float time): the state after that time; 0 at time 0.
    std::string text;
    int points = 4096;  // in a frame
};

/// Writes a complete signal. The error is the reason why Shadertoy can't draw it.
Result<ShadertoySignal> shadertoy_signal(const Spec& signal);
