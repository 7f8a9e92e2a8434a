#include "signals/beam/beam_sound.h"

#include "signals/beam/beam_sampler.h"

#include <cmath>

Sound beam_sound(const Signal& signal, const BeamSoundFormat& format) {
    const BeamSampler::Format samples{1.0 / format.rate, format.channels};
    Sound sound{format.rate, format.channels, {}};
    BeamSampler sampler;
    constexpr double fps = 60.0;
    Beam beam;
    for (std::int64_t frame = 1; static_cast<double>(frame - 1) / fps < format.seconds; ++frame) {
        const TimeSpan span = frame_span(frame, fps);
        beam.clear();
        signal.trace(span, beam);
        sampler.take(span, beam, samples, sound.samples);
    }
    const auto count = static_cast<std::size_t>(std::llround(format.seconds * format.rate));
    while (sound.frame_count() < count)
        sampler.rest(samples, sound.samples);
    sound.samples.resize(count * static_cast<std::size_t>(format.channels));
    return sound;
}
