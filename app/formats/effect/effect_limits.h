#pragma once

#include "formats/effect/effect_look.h"

#include <string>

/// Why a program can't draw a look, as a sentence with an alternative; "" if it can.
std::string effect_obstacle(const Look& look, const EffectHost& host);
