#pragma once

#include "base/diagnostic.h"

#include <map>
#include <string>
#include <string_view>

/// The value of a size expression such as "$WIDTH / floor($pixels)": numbers, + - * / %, brackets,
/// names behind '$', abs ceil floor log2 max min pow round sqrt, and finite, which is 0 for
/// what is no number or infinite; < <= > >= == !=, which give 1 or 0, and a ? b : c. Errors carry
/// no file.
Result<double> evaluate(std::string_view expression, const std::map<std::string, double>& names);
