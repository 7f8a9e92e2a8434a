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
};

/// Label, control, number and reset of one parameter, whatever its type.
void draw_parameter(const Knob& knob, const Fonts& fonts, Edits& edits);
