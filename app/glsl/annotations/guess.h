#pragma once

#include "model/look/parameter.h"

#include <string>

/// A parameter for a uniform that says nothing about its control: control and range guessed from
/// its type, name and default. The table is in docs/annotations.md.
Parameter guessed_parameter(const std::string& name, const NumberType& type, const Value& initial);
