#pragma once

#include "model/look/look.h"

#include <nlohmann/json_fwd.hpp>

/// A parameter of a look for other programs: type, default and current value, range, label, items,
/// and the passes that read it.
nlohmann::ordered_json parameter_json(const Parameter& parameter, const Look& look,
                                      const Values& values);
