#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <string>

/// A text field for the name in Dialog::text. It gets the focus in a new dialog. Returns the name
/// with the input of this frame.
std::string draw_name_field(const Scene& scene, Edits& edits);
/// Replaces the name in the field and gives it the focus.
void replace_name(const std::string& name, Edits& edits);
