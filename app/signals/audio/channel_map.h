#pragma once

#include "base/diagnostic.h"
#include "signals/signal/signal_kind.h"

#include <string>
#include <vector>

/// Maps channels of a sound or raw stream to properties of the beam. From 1; 0: unused.
struct ChannelMap {
    int x = 1;
    int y = 2;
    int intensity = 0;  // 0: full current
    int r = 0;          // without red, green and blue the beam is white
    int g = 0;
    int b = 0;

    bool has_tint() const { return r > 0 || g > 0 || b > 0; }
    bool is_plain() const { return intensity == 0 && !has_tint(); }
    /// The highest channel in use.
    int last() const;

    bool operator==(const ChannelMap&) const = default;
};

/// The settings of a map in their own group, with the defaults of `initial`.
std::vector<SettingInfo> channel_settings(const ChannelMap& initial,
                                          const SettingCondition& condition);
ChannelMap channel_map(const Settings& settings);

/// Fails for channels that the sound does not have. The same channel may be both x and y.
Result<void> check_channels(const ChannelMap& map, int channels);
