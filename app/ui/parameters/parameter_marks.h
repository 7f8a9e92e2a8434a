#pragma once

#include "ui/parameters/parameter_control.h"
#include "ui/widgets/form.h"

/// Star and padlock at the end of a parameter's label. Each is visible when it is set; both while
/// the pointer is on the label.
struct ParameterMarks {
    bool shows_star = false;
    bool shows_lock = false;
    float left = 0.0f;  // of the star, on the screen
    float width = 0.0f;

    /// The columns with the label shortened by the marks.
    FormColumns reduced(FormColumns columns) const;
};

/// For the row at the cursor.
ParameterMarks parameter_marks(const ParameterSetting& setting, const FormColumns& columns);
/// Draws the marks after the label.
void draw_parameter_marks(const ParameterEntry& entry, const ParameterMarks& marks, Edits& edits);

/// The marks as menu items.
void draw_parameter_items(const ParameterEntry& entry, Edits& edits);
