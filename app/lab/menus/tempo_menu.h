#pragma once

#include "lab/messages/menu_entry.h"
#include "model/tuning/tempo.h"

/// Tempo and bars.
MenuSection tempo_section(const Tempo& tempo);
