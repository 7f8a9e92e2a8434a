#pragma once

#include "signals/signal/signal_kind.h"

#include <array>

/// How a channel's input reaches its amplifier: whole, without its mean, or not at all.
enum class Coupling { dc, ac, ground };

/// The knobs of one channel of a scope. Full scale of a sound, and an amplitude of 1, are 1 V.
struct ScopeChannel {
    double volts_per_division = 0.25;
    double offset = 0.0;  // divisions, up (in xy of channel 1: to the right)
    Coupling coupling = Coupling::dc;
    bool is_inverted = false;
};

/// When a sweep begins.
struct Trigger {
    enum class Mode {
        off,        // at once after the last one
        automatic,  // at a trigger, or at once while there are none
        normal,     // at a trigger
        single,     // at the first trigger, and never again
    };

    Mode mode = Mode::automatic;
    int source = 0;              // channel 1 or 2; 0: the first one that is shown
    double level = 0.0;          // V
    bool is_rising = true;       // else falling
    double holdoff_seconds = 0;  // rest after a sweep
};

/// The knobs of a two-channel oscilloscope with 10 x 8 divisions.
struct ScopeKnobs {
    static constexpr double divisions_across = 10.0;
    static constexpr double divisions_up = 8.0;

    std::array<ScopeChannel, 2> channels;
    bool is_swapped = false;  // the inputs of the two channels
    bool is_xy = false;
    bool is_split = false;  // two traces have a half of the screen each
    double seconds_per_division = 1.0 / 600.0;
    Trigger trigger;

    double sweep_seconds() const { return divisions_across * seconds_per_division; }
};

/// Reads what scope_settings() asked for. `is_xy` is the caller's to say.
ScopeKnobs scope_knobs(const Settings& settings);

/// What differs between the scopes of different kinds of signal.
struct ScopeFacts {
    std::vector<std::string> yt_words;  // values of the setting `mode` that show traces over time
    std::vector<std::string> scope_words;       // and those that use the scope at all
    double seconds_per_division = 1.0 / 600.0;  // at the start
    double shortest_division = 1e-6;            // s
    std::string first_trigger = "auto";
};

/// The settings of a scope in the order of its knobs: vertical, horizontal, trigger.
std::vector<SettingFacts> scope_settings(const ScopeFacts& facts);
