#pragma once

#include "base/diagnostic.h"
#include "model/devices/live_sound.h"
#include "model/devices/sound.h"
#include "model/look/spec.h"
#include "model/plan/beam.h"
#include "signals/signal/clock.h"

#include <limits>
#include <memory>

/// What drives a scope: a pure function of time, so that real time and offline give the same points
/// for the same time.
class Signal {
public:
    virtual ~Signal() = default;

    /// Appends the points of the beam in `span`, oldest first, ages against span.end. Every sample
    /// falls into exactly one of adjoining spans; before time 0 there is none.
    virtual void trace(const TimeSpan& span, Beam& beam) const = 0;

    /// Its length; infinite when it has no end.
    virtual double seconds() const { return std::numeric_limits<double>::infinity(); }
};

struct BeamScene;
struct Drawing;
class SentBeam;

/// What a signal may need from outside: files are read by the caller.
struct SignalMedia {
    std::shared_ptr<const Sound> sound = nullptr;      // shared with the sound device's thread
    std::shared_ptr<const BeamScene> scene = nullptr;  // with the reading thread; never changed
    std::shared_ptr<const Drawing> drawing = nullptr;  // likewise
    std::shared_ptr<const LiveSound> live = nullptr;   // with the sound device's thread
    std::int64_t live_first = 0;                       // its frame at time 0
    std::shared_ptr<SentBeam> sent = nullptr;          // with the thread that reads it
};
