#pragma once

#include "ui/parameters/parameter_control.h"

/// Form rows for the modulation of a parameter; draws nothing for one that cannot be modulated.
void draw_modulation_editor(const ParameterEntry& entry, double beats_per_bar, const Fonts& fonts,
                            Edits& edits);
