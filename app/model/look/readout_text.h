#pragma once

#include "model/look/look.h"

#include <string>

/// "Lost light: 2.3 %". At most four digits.
std::string readout_text(const Readout& readout, double number);
