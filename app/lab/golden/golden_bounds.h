#pragma once

#include "model/picture/difference.h"

#include <optional>
#include <string>
#include <string_view>

/// The largest difference from a golden picture. Pictures are equal within the bounds if at most
/// `percent` of the pixels have a colour that differs by more than `levels`.
struct GoldenBounds {
    double levels = 2.0;   // of 255
    double percent = 0.1;  // of the pixels

    bool operator==(const GoldenBounds&) const = default;
};

/// "2/255" or "2", from 0 to 255 levels; nullopt: another text.
std::optional<double> parse_levels(std::string_view text);
/// "0.1 %" or "0.1", from 0 to 100 percent; nullopt: another text.
std::optional<double> parse_percent(std::string_view text);

/// "2/255".
std::string levels_text(double levels);
/// "0.1 %".
std::string percent_text(double percent);

/// Whether pictures are equal within the bounds. Their difference is in levels of 255, with
/// `bounds.levels` as tolerance.
bool is_within(const Difference& difference, const GoldenBounds& bounds);
