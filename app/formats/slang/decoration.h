#pragma once

#include <string_view>

/// A UTF-8 text without decoration at both ends: spaces, dashes, stars, arrows and footnote signs.
std::string_view without_decoration(std::string_view text);
