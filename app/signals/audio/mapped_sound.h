#pragma once

#include "signals/audio/channel_map.h"
#include "signals/audio/sample_stream.h"
#include "signals/signal/signal.h"

/// A sound in X-Y of which further channels are the beam's current and colour. Between the sound's
/// samples these go on in straight lines: a beam that is switched off must not ring.
class MappedSound : public Signal {
public:
    /// What the channels that a map names are read from.
    struct Streams {
        std::shared_ptr<const SampleStream> current_and_red;
        std::shared_ptr<const SampleStream> green_and_blue;
    };

    /// `place` draws every sample of the sound `factor` times, full current being even.
    MappedSound(std::unique_ptr<Signal> place, Streams streams, const ChannelMap& map, int factor);

    void trace(const TimeSpan& span, Beam& beam) const override;
    double seconds() const override { return m_place->seconds(); }

private:
    std::unique_ptr<Signal> m_place;
    Streams m_streams;
    ChannelMap m_map;
    int m_factor;
};
