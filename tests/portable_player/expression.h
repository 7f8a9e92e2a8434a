#pragma once

#include <functional>
#include <string>

/// Evaluates an expression of a look. `value_of` returns the number of a name without its '$'.
/// Fails with the expression for a syntax error.
double evaluate(const std::string& expression,
                const std::function<double(const std::string&)>& value_of);
