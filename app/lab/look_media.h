#pragma once

#include "base/diagnostic.h"
#include "model/look.h"

/// What is wrong with the pictures and sounds that a look brings along, and with the test pattern
/// that it starts with. Reads them all.
Diagnostics check_media(const Look& look);
