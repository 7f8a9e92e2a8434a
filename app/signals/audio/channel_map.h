#pragma once

#include "base/diagnostic.h"
#include "signals/signal/signal_kind.h"

#include <string>
#include <vector>

/// Which channel of a sound, or of a raw stream, is what of the beam; from 1, 0: none.
struct ChannelMap {
    int x = 1;
    int y = 2;
    int intensity = 0;  // none: full current
    int r = 0;          // without any of these three the beam is white
    int g = 0;
    int b = 0;

    bool has_tint() const { return r > 0 || g > 0 || b > 0; }
    bool is_plain() const { return intensity == 0 && !has_tint(); }
    /// The highest channel that is used.
    int last() const;

    bool operator==(const ChannelMap&) const = default;
};

/// The settings of a map under a heading of their own, with the values of `initial`.
std::vector<SettingFacts> channel_settings(const ChannelMap& initial, const UsedWhile& used_while);
ChannelMap channel_map(const Settings& settings);

/// Refuses channels that a sound does not have; one channel may still be x and y.
Result<void> check_channels(const ChannelMap& map, int channels);
