#pragma once

#include "model/look/parameter.h"

#include <string>

/// A parameter for a uniform without annotations. Control and range are guessed from its type, name
/// and default. The rules are in docs/annotations.md.
Parameter guessed_parameter(const std::string& name, const NumberType& type, const Value& initial);
