#pragma once

#include "ui/parameters/parameter_control.h"
#include "ui/widgets/form.h"

/// The star and the padlock at the end of a parameter's label: there when they are set, and both
/// while the pointer is on the label.
struct KnobMarks {
    bool shows_star = false;
    bool shows_lock = false;
    float left = 0.0f;  // of the star, on the screen
    float width = 0.0f;

    /// The columns with what is left to the label.
    FormColumns beside(FormColumns columns) const;
};

/// For the line that begins here.
KnobMarks knob_marks(const KnobSetting& setting, const FormColumns& columns);
/// Drawn behind the label.
void draw_knob_marks(const Knob& knob, const KnobMarks& marks, Edits& edits);

/// The same as lines of a menu.
void draw_knob_items(const Knob& knob, Edits& edits);
