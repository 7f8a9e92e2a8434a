#pragma once

#include "lab/document/document.h"

#include <string>

/// Why two drawings of a document differ: its signal or source is live; "": they don't.
std::string why_not_repeatable(const Document& document);
