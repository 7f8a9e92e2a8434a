#pragma once

#include "lab/rendering/period_terms.h"
#include "model/devices/midi.h"
#include "model/tuning/modulation.h"
#include "model/tuning/parameter_settings.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// One parameter of a look with its state, as the panel displays it.
struct ParameterEntry {
    const Parameter& parameter;
    const Value& value;
    bool is_changed = false;
    const ParameterSetting& setting;
    const Range& declared;  // without the user's own slider ends
    const Look& look;
    const Modulation* modulation = nullptr;  // null: not modulated
    const Value* now = nullptr;              // the modulated value of this frame
    PeriodInfo period = {};                  // of a pattern of pixels
    std::optional<std::size_t> typed = {};   // number to focus for typing
    std::vector<MidiBinding> midi = {};      // its controllers
    std::string without_effect = {};         // why it has no effect now; dims it
    float longest_label = 0.0f;              // width, of all parameters of the look
};

/// Number of rows the parameter needs, before it has been drawn.
int expected_lines(const Parameter& parameter);

/// Draws the label, control, number and reset of a parameter of any type. Returns whether its
/// control is active by mouse or keyboard.
bool draw_parameter(const ParameterEntry& entry, const Scene& scene, Edits& edits);
