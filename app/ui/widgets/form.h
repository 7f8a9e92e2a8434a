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
/// For the present pane; `has_button`: with room for form_reset().
FormColumns form_columns(bool has_button = true);
/// A line with a check box where numbers end; the rest is left to its label.
FormColumns check_box_columns();

/// Begins a line of a form with its label; the control is drawn next. Gives whether the label was
/// clicked, and leaves it the last item, for a tooltip.
bool form_label(const std::string& label, const FormColumns& columns, bool is_changed);
/// Moves to the control's column of the present line.
void form_control(const FormColumns& columns);

/// A slider with its number.
Turned form_slider(const char* id, double& value, const SliderFacts& facts,
                   const FormColumns& columns, const Fonts& fonts);

/// The reset button at the end of the line; only there when something is changed.
bool form_reset(const std::string& help, bool is_changed, const FormColumns& columns);

/// A combo box; true when another one of `labels` was chosen. It says `otherwise` while none is.
bool form_list(const char* id, const char* const* labels, int count, int& chosen, float width,
               const char* otherwise = "");
