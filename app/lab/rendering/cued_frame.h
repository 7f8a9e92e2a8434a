#pragma once

#include "lab/playback/sound_position.h"
#include "lab/rendering/executors.h"
#include "model/tuning/cue_plan.h"

#include <optional>

/// The cues of a frame: the same in the window and in a render.
class CuedFrame {
public:
    /// `plan` null: no cues. `part` of the signal's sound; nullopt: no sound. It must outlive this.
    CuedFrame(const CuePlan* plan, const TimeSpan& span, const std::optional<PlayedPart>& part);

    /// Null: no cues.
    const CuePlan* plan() const { return m_plan; }
    /// The position of the frame's end in the sound, or on the clock.
    double position() const { return m_to; }
    /// Whether the history must be cleared before the frame is drawn.
    bool restarts() const;
    /// Makes the picture black or shows it.
    void apply_blackout(Executors& executors) const;

private:
    const CuePlan* m_plan;
    double m_from;
    double m_to;
    double m_loop_start;
    double m_loop_end;
};
