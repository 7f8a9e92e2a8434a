#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>

/// The parameter that a person's name means: its own, or in a stack the last part of one name
/// alone. Fails with what was perhaps meant. Points into the look.
Result<const Parameter*> meant_parameter(const std::string& name, const Look& look);
