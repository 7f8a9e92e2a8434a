#pragma once

#include "signals/patterns/pattern.h"

/// 80 x 25 characters on a text terminal, in the colours of its day.
Pattern terminal_page_pattern();
