#pragma once

#include "base/diagnostic.h"

#include <map>
#include <string>
#include <string_view>

/// Evaluates a size expression such as "$WIDTH / floor($pixels)". Supports numbers, + - * / %,
/// brackets and names with the prefix '$'. Functions: abs ceil floor log (natural) log2 max min pow
/// round sqrt, and finite, which is 0 for NaN and infinity. < <= > >= == != && || ! give 1 or 0,
/// and a ? b : c selects. Errors have no file.
Result<double> evaluate(std::string_view expression, const std::map<std::string, double>& names);
