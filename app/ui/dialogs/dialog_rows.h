#pragma once

#include "ui/frame/edits.h"

#include <string>
#include <vector>

/// The width of the label column of dialogs with rows.
float dialog_label_width();

/// Starts a row: its label, then the control is drawn next. The control gets the remaining width.
void dialog_row(const char* label);
/// A line below a control, aligned with it: the problem of its field. "": no line.
void dialog_row_problem(const std::string& text, Edits& edits);

/// A text field. Returns the text, with the input of this frame.
std::string dialog_text(const char* id, const std::string& text, const std::string& hint,
                        float width, Edits& edits);

/// A list of choices with marks "ID:LABEL"; returns the chosen index.
std::size_t dialog_list(const char* id, const std::vector<std::string>& labels, std::size_t chosen,
                        float width, Edits& edits);
