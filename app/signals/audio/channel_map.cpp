#include "signals/audio/channel_map.h"

#include "signals/signal/settings.h"

#include <fmt/format.h>

#include <algorithm>

int ChannelMap::last() const {
    return std::max({x, y, intensity, r, g, b});
}

std::vector<SettingInfo> channel_settings(const ChannelMap& initial,
                                          const SettingCondition& condition) {
    const auto setting = [](const char* key, const char* label, const char* help, int channel) {
        return SettingInfo{.key = key,
                           .label = label,
                           .help = help,
                           .low = 0,
                           .high = 8,
                           .step = 1,
                           .initial = static_cast<double>(channel),
                           .limit = {0, 64}};
    };
    return in_group(
        "Channel map", condition,
        {setting("x", "X",
                 "Channel that moves the beam horizontally. 0: none, it stays in the middle.",
                 initial.x),
         setting("y", "Y",
                 "Channel that moves the beam vertically. 0: none, it stays in the middle.",
                 initial.y),
         setting("intensity", "Intensity",
                 "Channel of the beam current: 1 is full, 0 or less is blanked. Channel 0: none, "
                 "always full.",
                 initial.intensity),
         setting(
             "r", "Red",
             "Channel of the beam's red, 0 to 1. Without red, green and blue the beam is white.",
             initial.r),
         setting("g", "Green", "Channel of the beam's green. A colour without a channel is dark.",
                 initial.g),
         setting("b", "Blue", "Channel of the beam's blue. A colour without a channel is dark.",
                 initial.b)});
}

ChannelMap channel_map(const Settings& settings) {
    return {.x = settings.whole("x"),
            .y = settings.whole("y"),
            .intensity = settings.whole("intensity"),
            .r = settings.whole("r"),
            .g = settings.whole("g"),
            .b = settings.whole("b")};
}

Result<void> check_channels(const ChannelMap& map, int channels) {
    const ChannelMap usual;
    const auto check = [&](const char* name, int channel) -> Result<void> {
        if (channel <= channels)
            return {};
        return fail({{},
                     0,
                     channels == 1
                         ? fmt::format("'{}' is channel {}, but the sound has only 1 channel", name,
                                       channel)
                         : fmt::format("'{}' is channel {}, but the sound has only {} channels",
                                       name, channel, channels)});
    };
    for (const auto& [name, channel] : {std::pair("x", map.x),
                                        {"y", channels == 1 && map.y == usual.y ? 1 : map.y},
                                        {"intensity", map.intensity},
                                        {"r", map.r},
                                        {"g", map.g},
                                        {"b", map.b}})
        if (auto good = check(name, channel); !good)
            return good;
    return {};
}
