#pragma once

#include "signals/scope.h"
#include "signals/signal.h"
#include "signals/sound_input.h"

/// A sound on a scope, over time or one channel against the other, every sample drawn once.
class SoundScope : public Signal {
public:
    SoundScope(const std::shared_ptr<const Sound>& sound, const SoundPart& part,
               const SoundPlug& plug, const ScopeKnobs& knobs);

    void trace(const TimeSpan& span, Beam& beam) const override;
    double seconds() const override;

private:
    SoundInput m_input;
    Scope m_scope;
    std::unique_ptr<Sweeps> m_sweeps;
};
