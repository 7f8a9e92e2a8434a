#include "lab/sequencer/sound_region.h"

#include "lab/document/content_edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {
// Ends are stored with a resolution of 1 ms, so that presets stay readable.
double rounded(double seconds) {
    return std::round(seconds * 1000.0) / 1000.0;
}

void set_setting(Spec& spec, const char* key, double seconds) {
    if (seconds > 0.0)
        spec.settings[key] = seconds;
    else
        spec.settings.erase(key);
}

// `end` 0: the end of the sound.
void change_part(Document& document, Player& player, const PlayedPart& next, double end) {
    const auto current = played_part(player.signal());
    const double position = current->position_at(player.transport().time());
    Spec spec = document.state().signal;
    set_setting(spec, "start", next.start);
    set_setting(spec, "end", end);
    if (next.loops)
        spec.settings.erase("loop");  // "on" is the default
    set_signal(document, std::move(spec), false,
               end > 0.0 ? "Set loop region" : "Remove loop region");
    const bool is_within = position >= next.start && position < next.end;
    player.seek(is_within ? next.time_at(position) : 0.0);
}
}  // namespace

bool has_region(const PlayedSignal& signal) {
    const auto part = played_part(signal);
    constexpr double slack = 1e-6;
    return part && part->seconds() < signal.track().sound->seconds() - slack;
}

void set_region(Document& document, Player& player, double start, double end) {
    const auto current = played_part(player.signal());
    if (!current || !std::isfinite(start) || !std::isfinite(end))
        return;
    const double length = player.signal().track().sound->seconds();
    const double first = rounded(std::clamp(std::min(start, end), 0.0, length));
    const double last = rounded(std::clamp(std::max(start, end), 0.0, length));
    if (last - first < shortest_region)
        return;
    change_part(document, player, {first, last, true}, last);
}

void remove_region(Document& document, Player& player) {
    const auto current = played_part(player.signal());
    if (!current)
        return;
    const double length = player.signal().track().sound->seconds();
    change_part(document, player, {0.0, length, current->loops}, 0.0);
}
