#pragma once

#include "signals/patterns/pattern.h"

/// A text terminal of 80 x 25 characters in period colours.
Pattern terminal_page_pattern();
