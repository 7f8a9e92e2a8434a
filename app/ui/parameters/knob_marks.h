#pragma once

#include "ui/parameters/parameter_control.h"
#include "ui/widgets/form.h"

/// Star and padlock at the end of a parameter's label. Each is visible when it is set; both while
/// the pointer is on the label.
struct KnobMarks {
    bool shows_star = false;
    bool shows_lock = false;
    float left = 0.0f;  // of the star, on the screen
    float width = 0.0f;

    /// The columns with the label shortened by the marks.
    FormColumns beside(FormColumns columns) const;
};

/// For the row at the cursor.
KnobMarks knob_marks(const KnobSetting& setting, const FormColumns& columns);
/// Draws the marks after the label.
void draw_knob_marks(const Knob& knob, const KnobMarks& marks, Edits& edits);

/// The marks as menu items.
void draw_knob_items(const Knob& knob, Edits& edits);
