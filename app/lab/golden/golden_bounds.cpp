#include "lab/golden/golden_bounds.h"

#include "base/text.h"

namespace {
std::optional<double> parse_with_unit(std::string_view text, std::string_view unit,
                                      double largest) {
    text = trim(text);
    if (text.ends_with(unit))
        text = trim(text.substr(0, text.size() - unit.size()));
    const auto number = parse_number(text);
    return number && *number >= 0.0 && *number <= largest ? number : std::nullopt;
}
}  // namespace

std::optional<double> parse_levels(std::string_view text) {
    return parse_with_unit(text, "/255", 255.0);
}

std::optional<double> parse_percent(std::string_view text) {
    return parse_with_unit(text, "%", 100.0);
}

std::string levels_text(double levels) {
    return format_number(levels) + "/255";
}

std::string percent_text(double percent) {
    return format_number(percent) + " %";
}

bool is_within(const Difference& difference, const GoldenBounds& bounds) {
    return 100.0 * difference.share_beyond <= bounds.percent;
}
