#pragma once

#include <string>

/// A number in at most `maximum` characters (at least 5), as exactly as they allow, without
/// needless zeros: "0.333", "-12.3", "7e-6". Shows at most 7 digits, the precision of a 32-bit
/// float.
std::string fitted_number(double number, int maximum);
