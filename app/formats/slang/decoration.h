#pragma once

#include <string_view>

/// A text in UTF-8 without the blanks, dashes, stars, arrows and footnote signs that decorate it on
/// both sides.
std::string_view without_decoration(std::string_view text);
