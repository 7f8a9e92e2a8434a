#pragma once

#include "signals/audio/channel_map.h"
#include "signals/audio/sample_stream.h"
#include "signals/signal/signal.h"

/// A sound in X-Y mode with channels for the beam's current and colour. These are interpolated
/// linearly: a blanked beam must not ring.
class MappedSound : public Signal {
public:
    /// The streams for the channels of a map.
    struct Streams {
        std::shared_ptr<const SampleStream> current_and_red;
        std::shared_ptr<const SampleStream> green_and_blue;
    };

    /// `signal` draws each sample of the sound `factor` times at constant full current.
    MappedSound(std::unique_ptr<Signal> signal, Streams streams, const ChannelMap& map, int factor);

    void trace(const TimeSpan& span, Beam& beam) const override;
    double seconds() const override { return m_signal->seconds(); }

private:
    std::unique_ptr<Signal> m_signal;
    Streams m_streams;
    ChannelMap m_map;
    int m_factor;
};
