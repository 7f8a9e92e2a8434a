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
/// For the current pane. `has_button`: reserves space for form_reset().
FormColumns form_columns(bool has_button = true);
/// A row with a check box at the right end of the number column; the label gets the remaining
/// width.
FormColumns check_box_columns();

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
