#pragma once

#include "signals/signal/signal_kind.h"

#include <array>

/// Input coupling of a channel: unchanged, without its mean, or off.
enum class Coupling { dc, ac, ground };

/// Settings of one scope channel. Full scale of a sound, and an amplitude of 1, are 1 V.
struct ScopeChannel {
    double volts_per_division = 0.25;
    double offset = 0.0;  // divisions, upwards (in xy for channel 1: to the right)
    Coupling coupling = Coupling::dc;
    bool is_inverted = false;
};

/// When a sweep starts.
struct Trigger {
    enum class Mode {
        off,        // immediately after the last one
        automatic,  // at a trigger, or immediately without one
        normal,     // at a trigger
        single,     // at the first trigger only
    };

    Mode mode = Mode::automatic;
    int source = 0;              // channel 1 or 2; 0: the first visible one
    double level = 0.0;          // V
    bool is_rising = true;       // otherwise falling
    double holdoff_seconds = 0;  // pause after a sweep
};

/// Settings of a two-channel oscilloscope with 10 x 8 divisions.
struct ScopeControls {
    static constexpr double divisions_across = 10.0;
    static constexpr double divisions_up = 8.0;

    std::array<ScopeChannel, 2> channels;
    bool is_swapped = false;  // the inputs of the two channels
    bool is_xy = false;
    bool is_split = false;  // each of two traces uses half of the screen
    double seconds_per_division = 1.0 / 600.0;
    Trigger trigger;

    double sweep_seconds() const { return divisions_across * seconds_per_division; }
};

/// Reads the settings of scope_settings(). The caller sets `is_xy`.
ScopeControls scope_controls(const Settings& settings);

/// Differences between the scopes of the kinds of signal.
struct ScopeInfo {
    std::vector<std::string> yt_modes;          // values of `mode` that show traces over time
    std::vector<std::string> scope_modes;       // values of `mode` that use the scope
    double seconds_per_division = 1.0 / 600.0;  // default
    double shortest_division = 1e-6;            // s
    std::string first_trigger = "auto";
};

/// The settings of a scope: vertical, horizontal, trigger.
std::vector<SettingInfo> scope_settings(const ScopeInfo& info);
