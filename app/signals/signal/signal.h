#pragma once

#include "base/diagnostic.h"
#include "model/devices/live_sound.h"
#include "model/devices/sound.h"
#include "model/look/spec.h"
#include "model/plan/beam.h"
#include "model/tuning/repetition.h"
#include "signals/signal/clock.h"

#include <limits>
#include <memory>

/// Input of a scope look: a pure function of time. Real-time and offline drawing therefore get the
/// same points for the same time.
class Signal {
public:
    virtual ~Signal() = default;

    /// Appends the points of the beam in `span`, oldest first. Ages are relative to span.end. Each
    /// sample belongs to exactly one of several adjoining spans. There are no samples before time
    /// 0.
    virtual void trace(const TimeSpan& span, Beam& beam) const = 0;

    /// Duration; infinite for a signal without an end.
    virtual double seconds() const { return std::numeric_limits<double>::infinity(); }

    /// How it repeats, apart from a sound that it plays. By default unknown.
    virtual Repetition repetition() const { return {}; }
};

struct BeamScene;
struct Drawing;
class BeamInput;

/// External data of a signal. The caller reads the files.
struct SignalMedia {
    std::shared_ptr<const Sound> sound = nullptr;      // shared with the audio device thread
    std::shared_ptr<const BeamScene> scene = nullptr;  // shared with the reading thread; immutable
    std::shared_ptr<const Drawing> drawing = nullptr;  // same
    std::shared_ptr<const LiveSound> live = nullptr;   // shared with the audio device thread
    std::int64_t live_first = 0;                       // frame number at time 0
    std::shared_ptr<BeamInput> sent = nullptr;         // shared with the thread that reads it
};
