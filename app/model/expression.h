#pragma once

#include "base/diagnostic.h"

#include <map>
#include <string>
#include <string_view>

/// The value of a size expression such as "$WIDTH / floor($pixels)": numbers, + - * / %, brackets,
/// names behind '$', and abs ceil floor max min pow round sqrt. Errors carry no file.
Result<double> evaluate(std::string_view expression, const std::map<std::string, double>& names);
