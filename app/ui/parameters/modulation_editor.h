#pragma once

#include "ui/parameters/parameter_control.h"

/// Lines of a form that say what moves a parameter by itself; nothing for one that cannot move.
void draw_modulation_editor(const Knob& knob, const Fonts& fonts, Edits& edits);
