#pragma once

#include "signals/audio/sound_input.h"
#include "signals/scope/scope.h"
#include "signals/signal/signal.h"

/// A sound on a scope: traces over time, or one channel against the other. Draws each sample once.
class SoundScope : public Signal {
public:
    SoundScope(std::shared_ptr<const SampleStream> sound, const SoundInputSettings& plug,
               const ScopeControls& controls);

    void trace(const TimeSpan& span, Beam& beam) const override;
    double seconds() const override { return m_input.seconds(); }

private:
    SoundInput m_input;
    Scope m_scope;
    std::unique_ptr<Sweeps> m_sweeps;
};
