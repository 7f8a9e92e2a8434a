#pragma once

#include "model/look/look.h"
#include "model/tuning/modulation.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

/// A cue with its values for a look.
struct CueAction {
    enum class Kind { values, restart, blackout };

    double seconds = 0.0;  // position in the sound; without a sound, time of the clock
    Kind kind = Kind::values;
    double over = 0.0;                            // s, duration of the change
    Values values = {};                           // goals of the changed parameters
    std::optional<Modulations> modulations = {};  // of a preset, at the end of the change
    bool is_on = true;                            // of blackout
};

/// The values and modulations of a frame.
struct CuedState {
    Values values;
    Modulations modulations;
};

/// What the cues of a file do to a look. All its functions are pure functions of the position, so a
/// seek, a loop and a render show the same frames as playback.
class CuePlan {
public:
    CuePlan() = default;
    /// Sorts the actions by time; those at the same time stay in their order.
    explicit CuePlan(std::vector<CueAction> actions);

    bool is_empty() const { return m_actions.empty(); }
    /// Whether a cue changes the parameter.
    bool changes(const std::string& parameter) const;
    /// The state at a position, from the state without cues. A later cue of a parameter replaces an
    /// earlier one, and starts at its value at that time. Changes follow model/tuning/morph.h.
    CuedState state_at(const Look& look, const CuedState& without, double position) const;
    bool is_black_at(double position) const;
    /// Whether a frame that covers the positions after `from` up to `to` restarts the picture. `to`
    /// < `from`: the loop of `loop_start` to `loop_end` has begun again.
    bool restarts_within(double from, double to, double loop_start, double loop_end) const;

private:
    Value value_at(const Parameter& parameter, const Value& without, double position,
                   std::size_t count) const;

    std::vector<CueAction> m_actions;
    std::set<std::string> m_changed;  // parameters
};

/// Why a cue can't change this parameter, as a sentence; "" if it can. Cues change values between
/// frames, so parameters that recompile the look are excluded.
std::string cue_refusal(const Parameter& parameter);
