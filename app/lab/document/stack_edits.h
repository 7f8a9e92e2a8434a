#pragma once

#include "lab/document/document.h"

#include <string>

/// Sets the looks and their order. Values move with their looks.
void set_stack(Document& document, Stack stack, const std::string& step_name);
void set_override(Document& document, const std::string& pass, PassOverride override);
void clear_overrides(Document& document);
