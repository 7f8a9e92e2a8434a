#pragma once

#include "lab/rendering/period_terms.h"
#include "model/devices/midi.h"
#include "model/tuning/knob_settings.h"
#include "model/tuning/modulation.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// One knob of a look as the panel shows it.
struct Knob {
    const Parameter& parameter;
    const Value& value;
    bool is_changed = false;
    const KnobSetting& setting;
    const Range& declared;  // the parameter's own range is what the person made of it
    const Look& look;
    const Modulation* modulation = nullptr;  // null: it rests
    const Value* now = nullptr;              // as drawn, while it moves by itself
    PeriodFacts period = {};                 // of what repeats on pixels
    std::optional<std::size_t> typed = {};   // which of its numbers has the keyboard from now on
    std::vector<MidiBinding> midi = {};      // what turns it
};

/// Lines of the panel that a parameter takes, before it has been drawn.
int expected_lines(const Parameter& parameter);

/// Label, control, number and reset of one parameter, whatever its type; whether the hand or the
/// keyboard is on its control.
bool draw_parameter(const Knob& knob, const Scene& scene, Edits& edits);
