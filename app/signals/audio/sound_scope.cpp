#include "signals/audio/sound_scope.h"

#include "signals/audio/triggered_sweeps.h"

namespace {
// By scope channel.
std::array<bool, 2> shown(const SoundInputSettings& plug) {
    if (plug.is_swapped)
        return {plug.shows_right(), plug.shows_left()};
    return {plug.shows_left(), plug.shows_right()};
}

std::unique_ptr<Sweeps> sweeps_of(const SoundInput& input, const SoundInputSettings& plug,
                                  const ScopeControls& controls, double length) {
    const Trigger& trigger = controls.trigger;
    if (trigger.mode == Trigger::Mode::off || controls.is_xy)
        return std::make_unique<PeriodicSweeps>(0.0, length, length);
    std::size_t channel = shown(plug)[0] ? 0 : 1;
    if (trigger.source != 0)
        channel = static_cast<std::size_t>(trigger.source - 1);
    return std::make_unique<TriggeredSweeps>(input, trigger, channel,
                                             controls.channels[channel].is_inverted, length);
}
}  // namespace

SoundScope::SoundScope(std::shared_ptr<const SampleStream> sound, const SoundInputSettings& plug,
                       const ScopeControls& controls)
    : m_input(std::move(sound), plug),
      m_scope(controls, shown(plug), m_input.rate()),
      m_sweeps(sweeps_of(m_input, plug, controls, m_scope.sweep_samples())) {}

void SoundScope::trace(const TimeSpan& span, Beam& beam) const {
    // A sweep with two traces can extend slightly beyond the span.
    const auto ahead = static_cast<std::int64_t>(m_input.rate() / 60.0) + 2;
    SoundReader reader(m_input, samples_in(span, m_input.rate()).end + ahead);
    m_scope.trace(span, m_input.count(), *m_sweeps, beam,
                  [&](std::int64_t sample, double) { return reader.at(sample); });
}
