#pragma once

#include "model/knob_settings.h"
#include "ui/edits.h"
#include "ui/fonts.h"

/// One knob of a look as the panel shows it.
struct Knob {
    const Parameter& parameter;
    const Value& value;
    bool is_changed = false;
    const KnobSetting& setting;
    const Range& declared;  // the parameter's own range is what the person made of it
};

/// Lines of the panel that a parameter takes, before it has been drawn.
int expected_lines(const Parameter& parameter);

/// Label, control, number and reset of one parameter, whatever its type; whether the hand or the
/// keyboard is on its control.
bool draw_parameter(const Knob& knob, const Fonts& fonts, Edits& edits);
