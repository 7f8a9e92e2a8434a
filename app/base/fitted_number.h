#pragma once

#include <string>

/// A number in at most so many letters (at least 5), as exactly as these can tell, without needless
/// zeros: "0.333", "-12.3", "7e-6". Of more digits than a 32-bit float has none is shown.
std::string fitted_number(double number, int most);
