#include "ui/passes/strip_text.h"

#include "ui/widgets/slider.h"

#include <fmt/format.h>

#include <cmath>

namespace {
std::string percent_text(double share) {
    return fmt::format("{:.{}f} %", share * 100.0, share < 0.0995 ? 1 : 0);
}

// A peak at the ceiling can round to above it. Adding 0.0 avoids "-0.0".
std::string stops_text(double stops) {
    return fmt::format("{:.1f}", std::round(stops * 10.0) / 10.0 + 0.0);
}
}  // namespace

std::string strip_text::info(const PlannedTarget& target) {
    return fmt::format("{}×{} {}", target.extent.width, target.extent.height,
                       info_of(target.format).name);
}

std::string strip_text::info(const PlannedTarget& first, const PlannedTarget& last) {
    return fmt::format("{}×{} to {}×{}", first.extent.width, first.extent.height, last.extent.width,
                       last.extent.height);
}

// Three significant digits.
std::string strip_text::time(double milliseconds) {
    if (milliseconds <= 0.0)
        return {};
    const int decimals = milliseconds < 99.995 ? 2 : milliseconds < 999.95 ? 1 : 0;
    return fmt::format("{:.{}f} ms", milliseconds, decimals);
}

bool strip_text::is_clipped(const TargetLevel& gain) {
    constexpr double counts = 0.0005;  // shown as "0.1 %"
    return gain.clipped >= counts;
}

std::string strip_text::gain(const TargetLevel& gain, bool is_narrow) {
    if (is_narrow && is_clipped(gain))
        return fmt::format("{} clipped", percent_text(gain.clipped));
    if (is_clipped(gain))
        return fmt::format("peak {:.3g}, {} clipped", gain.peak, percent_text(gain.clipped));
    const auto headroom = headroom_stops(gain);
    if (!headroom)
        return "black";
    if (is_narrow || *headroom > meter_stops)
        return fmt::format("peak {:.3g}", gain.peak);
    return fmt::format("peak {:.3g}, {} stops", gain.peak, stops_text(*headroom));
}

std::string strip_text::gain_help(const TargetLevel& gain) {
    const auto headroom = headroom_stops(gain);
    const std::string peak =
        fmt::format("Peak {}, mean {}", short_number(gain.peak), short_number(gain.mean));
    const std::string clipped =
        fmt::format("{} clipped at {}", percent_text(gain.clipped), short_number(gain.ceiling));
    return headroom
               ? fmt::format("{}\n{}\n{} stops of headroom", peak, clipped, stops_text(*headroom))
               : fmt::format("{}\n{}\nBlack", peak, clipped);
}

std::string strip_text::change(const PassChange& change, bool is_narrow) {
    if (!change.has_changed())
        return "unchanged";
    const double percent = 100.0 * change_share(change);
    const std::string share = percent < 0.01 ? "< 0.01 %" : fmt::format("{:.2g} %", percent);
    return is_narrow ? share : fmt::format("changed {}", share);
}
