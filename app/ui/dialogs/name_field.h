#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <string>

/// A text field for the name in Dialog::text, with the focus, and the problem of this name below
/// it. While the dialog is new, the field has `proposed`. Returns the name.
std::string draw_name_field(const std::string& proposed, const Scene& scene, Edits& edits);
/// The problem of the name, in one reserved line.
void draw_name_problem(const std::string& problem, Edits& edits);
