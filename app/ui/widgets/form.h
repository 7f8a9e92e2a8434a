#pragma once

#include "ui/frame/fonts.h"
#include "ui/widgets/slider.h"

#include <imgui/imgui.h>

#include <string>

/// The columns of a form: label, control, number, and a small button at the right end.
struct FormColumns {
    float label = 0.0f;
    float control = 0.0f;
    float number = 0.0f;
    float button = 0.0f;

    float control_and_number() const;
};
/// For the current pane, whose longest label has this width; 0: a usual one. Sliders get what
/// labels and numbers leave. All rows end at the same edge, with space for form_reset() behind it.
FormColumns form_columns(float longest_label = 0.0f);
/// A row with a check box at the right end of the number column; the label gets the remaining
/// width.
FormColumns check_box_columns();
/// The width from the cursor to the right edge of the rows.
float form_width();

/// Starts a row with its label; draw the control next. Returns whether the label was clicked. The
/// label is the last item, so a tooltip can follow.
bool form_label(const std::string& label, const FormColumns& columns, bool is_changed);
/// Moves to the control column of the current row.
void form_control(const FormColumns& columns);

/// A slider with its number field.
ValueEdit form_slider(const char* id, double& value, const SliderInfo& info,
                      const FormColumns& columns, const Fonts& fonts);

/// The reset button at the end of a row, only drawn if `is_changed`.
bool form_reset(const std::string& help, bool is_changed, const FormColumns& columns);

/// A combo box; true when another label is chosen. Shows `otherwise` if none is chosen.
bool form_list(const char* id, const char* const* labels, int count, int& chosen, float width,
               const char* otherwise = "");
