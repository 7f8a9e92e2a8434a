#include "signals/channel_map.h"

#include "signals/settings.h"

#include <fmt/format.h>

#include <algorithm>

int ChannelMap::last() const {
    return std::max({x, y, intensity, r, g, b});
}

std::vector<SettingFacts> channel_settings(const ChannelMap& initial, const UsedWhile& used_while) {
    const auto setting = [](const char* key, const char* label, const char* help, int channel) {
        return SettingFacts{.key = key,
                            .label = label,
                            .unit = "channel",
                            .help = help,
                            .low = 0,
                            .high = 8,
                            .step = 1,
                            .initial = static_cast<double>(channel),
                            .limit = {0, 64}};
    };
    return in_group(
        "Channel map", used_while,
        {setting("x", "X", "What moves the beam across; 0: none, it stays in the middle.",
                 initial.x),
         setting("y", "Y", "What moves the beam up; 0: none, it stays in the middle.", initial.y),
         setting("intensity", "Intensity",
                 "The beam's current: 1 is full, 0 and less is blanked. 0: none, always full.",
                 initial.intensity),
         setting("r", "Red", "The beam's red, 0 to 1. Without red, green and blue it is white.",
                 initial.r),
         setting("g", "Green", "The beam's green. A colour without a channel is dark.", initial.g),
         setting("b", "Blue", "The beam's blue. A colour without a channel is dark.", initial.b)});
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
        return fail(
            {{},
             0,
             fmt::format("{} is channel {}, but the sound has {}", name, channel,
                         channels == 1 ? "1 channel" : fmt::format("{} channels", channels))});
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
