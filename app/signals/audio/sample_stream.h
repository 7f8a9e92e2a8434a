#pragma once

#include "model/devices/live_sound.h"
#include "model/devices/sound.h"
#include "signals/signal/stereo_sample.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

/// Stereo samples by their number, from 0 on: where the signals of a sound read from.
class SampleStream {
public:
    virtual ~SampleStream() = default;

    static constexpr std::int64_t endless = std::numeric_limits<std::int64_t>::max() / 64;

    virtual int rate() const = 0;
    /// Samples, endless where they never end.
    virtual std::int64_t length() const = 0;
    /// Whether it begins again after its length; else there is silence on both sides.
    virtual bool loops() const = 0;
    /// Whether samples come in only as time goes by.
    virtual bool is_live() const = 0;
    /// The samples first, first + 1, ...; any number.
    virtual void read(std::int64_t first, std::span<StereoSample> samples) const = 0;
};

/// Which part of a sound is read, and how it goes on at its ends.
struct SoundPart {
    std::int64_t first = 0;  // sample frame where it begins
    bool loops = false;
};

/// The channels that are read as left and right, from 1; 0: none, silence. Beyond the last one it
/// is the last one, so that mono is on both sides.
struct StreamChannels {
    int left = 1;
    int right = 2;
};

/// A sound in memory, which has a rate, a channel and, from part.first on, a sample.
std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const Sound> sound,
                                              const SoundPart& part,
                                              const StreamChannels& channels = {});

/// A sound that comes in; its sample 0 is the frame `first`, which may be one to come or before
/// all.
std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const LiveSound> sound,
                                              std::int64_t first,
                                              const StreamChannels& channels = {});
