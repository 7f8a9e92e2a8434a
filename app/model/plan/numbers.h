#pragma once

#include "model/look/look.h"

#include <map>
#include <string>

/// The names of parameters in expressions, with their numbers: "exposure", and for a vector also
/// "tint.x" to "tint.w". `scope`: only those of one look of a stack, without its prefix "crt/".
std::map<std::string, double> numbers_of(const Look& look, const Values& values,
                                         const std::string& scope = {});
