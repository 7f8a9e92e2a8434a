#include "signals/scope/scope_controls.h"

#include "signals/signal/settings.h"

#include <algorithm>

namespace {
Coupling coupling_of(std::string_view word) {
    if (word == "ac")
        return Coupling::ac;
    return word == "gnd" ? Coupling::ground : Coupling::dc;
}

ScopeChannel channel_of(const Settings& settings, const std::string& number) {
    return {.volts_per_division = settings.number("v" + number),
            .offset = settings.number("o" + number),
            .coupling = coupling_of(settings.word("coupling" + number)),
            .is_inverted = settings.is("invert" + number, "on")};
}

Trigger::Mode trigger_mode(std::string_view word) {
    if (word == "off")
        return Trigger::Mode::off;
    if (word == "normal")
        return Trigger::Mode::normal;
    return word == "single" ? Trigger::Mode::single : Trigger::Mode::automatic;
}

int trigger_source(std::string_view word) {
    if (word == "shown")
        return 0;
    return word == "1" ? 1 : 2;
}

std::vector<SettingInfo> channel_settings(const std::string& number) {
    return {
        {.key = "v" + number,
         .label = "Vertical scale",
         .unit = "V/div",
         .help = "Volts per division (8 divisions high). Full scale of a sound and an amplitude "
                 "of 1 are 1 V, so at 0.25 they reach the edge.",
         .low = 0.002,
         .high = 5,
         .initial = 0.25,
         .logarithmic = true,
         .limit = {1e-5, 1000}},
        {.key = "o" + number,
         .label = "Position",
         .unit = "div",
         .help = "Position of 0 V above the middle. In XY mode, of channel 1 to the right.",
         .low = -4,
         .high = 4,
         .limit = {-1000, 1000}},
        choice_setting("coupling" + number, "Coupling",
                       "dc: the whole input. ac: removes frequencies below 5 Hz. gnd: 0 V.",
                       {"dc", "ac", "gnd"}),
        choice_setting("invert" + number, "Invert", "on: inverts the channel.", {"off", "on"})};
}

std::vector<SettingInfo> vertical_settings(const SettingCondition& on_a_scope) {
    std::vector<SettingInfo> settings = in_group("Channel 1", on_a_scope, channel_settings("1"));
    std::vector<SettingInfo> second = channel_settings("2");
    second.push_back(choice_setting(
        "swap", "Swap inputs", "on: exchanges the inputs of channels 1 and 2.", {"off", "on"}));
    for (SettingInfo& setting : in_group("Channel 2", on_a_scope, std::move(second)))
        settings.push_back(std::move(setting));
    return settings;
}

std::vector<SettingInfo> horizontal_settings(const ScopeInfo& info) {
    return {{.key = "sdiv",
             .label = "Time base",
             .unit = "s/div",
             .help = "Seconds per division. A sweep is 10 divisions long.",
             .low = std::max(1e-5, info.shortest_division),
             .high = 1,
             .initial = info.seconds_per_division,
             .logarithmic = true,
             .limit = {info.shortest_division, 100}},
            choice_setting("layout", "Trace layout",
                           "split: each trace gets half of the screen, so a graticule division "
                           "counts double. overlaid: both traces share the whole screen.",
                           {"split", "overlaid"})};
}

std::vector<SettingInfo> trigger_settings(const ScopeInfo& info) {
    std::vector<SettingInfo> settings{
        choice_setting(
            "trigger", "Trigger",
            "auto: sweeps on each trigger, or without one after 0.1 s. normal: waits for a "
            "trigger with a dark screen. single: sweeps once, on the first trigger after a "
            "restart. off: sweeps continuously.",
            {"auto", "normal", "single", "off"}),
        choice_setting("trigger_source", "Source",
                       "Channel to trigger on. shown: the first visible channel.",
                       {"shown", "1", "2"}),
        {.key = "trigger_level",
         .label = "Level",
         .unit = "V",
         .help = "Voltage that starts a sweep, after coupling and inversion.",
         .low = -1,
         .high = 1,
         .limit = {-1000, 1000}},
        choice_setting("slope", "Slope", "Direction in which the signal crosses the level.",
                       {"rising", "falling"}),
        {.key = "holdoff",
         .label = "Hold-off",
         .unit = "s",
         .help = "Time after a sweep in which triggers are ignored.",
         .low = 0,
         .high = 0.5,
         .limit = {0, 100}}};
    settings.front().initial_word = info.first_trigger;
    return settings;
}
}  // namespace

ScopeControls scope_controls(const Settings& settings) {
    return {.channels = {channel_of(settings, "1"), channel_of(settings, "2")},
            .is_swapped = settings.is("swap", "on"),
            .is_xy = settings.is("mode", "xy"),
            .is_split = settings.is("layout", "split"),
            .seconds_per_division = settings.number("sdiv"),
            .trigger = {.mode = trigger_mode(settings.word("trigger")),
                        .source = trigger_source(settings.word("trigger_source")),
                        .level = settings.number("trigger_level"),
                        .is_rising = settings.is("slope", "rising"),
                        .holdoff_seconds = settings.number("holdoff")}};
}

std::vector<SettingInfo> scope_settings(const ScopeInfo& info) {
    const SettingCondition on_a_scope{"mode", info.scope_modes};
    const SettingCondition over_time{"mode", info.yt_modes};
    std::vector<SettingInfo> all = vertical_settings(on_a_scope);
    for (SettingInfo& setting : in_group("Horizontal", over_time, horizontal_settings(info)))
        all.push_back(std::move(setting));
    for (SettingInfo& setting : in_group("Trigger", over_time, trigger_settings(info)))
        all.push_back(std::move(setting));
    return all;
}
