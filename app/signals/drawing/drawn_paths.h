#pragma once

#include "base/diagnostic.h"
#include "model/look/spec.h"
#include "signals/drawing/line_morph.h"
#include "signals/drawing/scene.h"

#include <optional>
#include <vector>

/// The keyframes of a drawing in playback order, with the timing of KeyframeOrder.
struct DrawnSteps {
    std::vector<std::vector<LineMorph>> steps;  // lines from one keyframe to the next
    bool loops = false;
    double hold_seconds = 0.0;
    double morph_seconds = 0.0;
    bool is_eased = true;
    double spin = 0.0;        // degrees/s, about the vertical axis
    double beam_speed = 1e3;  // half screens/s
    double refresh = 60.0;    // maximum drawings per second
};

/// What a signal that draws paths draws: a text and a scene, or a drawing. Both are empty for other
/// signals. The settings of the signal are applied.
struct DrawnPaths {
    std::optional<BeamScene> scene;
    std::optional<DrawnSteps> drawing;
};
Result<DrawnPaths> drawn_paths(const Spec& completed, const SignalMedia& media);
