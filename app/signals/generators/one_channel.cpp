#include "signals/generators/one_channel.h"

SettingInfo periods_setting(std::string key, std::string label, std::string help, double initial) {
    return {.key = std::move(key),
            .label = std::move(label),
            .unit = "per 1/60 s",
            .help = std::move(help),
            .low = 0.5,
            .high = 100,
            .initial = initial,
            .logarithmic = true,
            .limit = {0.001, 10000}};
}

std::vector<SettingInfo> one_channel_settings(std::vector<SettingInfo> own) {
    own.push_back(amplitude_setting(0.8));
    own.push_back({.key = "speed",
                   .label = "Scroll",
                   .unit = "screens/s",
                   .help = "Speed of the trace to the left, in YT mode.",
                   .low = -1,
                   .high = 1,
                   .limit = {-1000, 1000},
                   .condition = {"mode", {"yt"}}});
    own.push_back(
        {.key = "mode",
         .label = "Mode",
         .help = "yt: trace over time. xy: horizontal against vertical, a quarter period apart.",
         .type = SettingType::word,
         .words = {"yt", "xy"},
         .initial_word = "yt"});
    own.push_back(points_setting());
    return own;
}
