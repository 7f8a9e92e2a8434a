#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>

/// The parameter with this name; in a stack also by the last part of its name, if unique. Fails
/// with suggestions. The pointer is into the look.
Result<const Parameter*> resolve_parameter(const std::string& name, const Look& look);
