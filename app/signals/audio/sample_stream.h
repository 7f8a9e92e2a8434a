#pragma once

#include "model/devices/live_sound.h"
#include "model/devices/sound.h"
#include "signals/signal/stereo_sample.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

/// Stereo samples by number, from 0: the input of all sound signals.
class SampleStream {
public:
    virtual ~SampleStream() = default;

    static constexpr std::int64_t endless = std::numeric_limits<std::int64_t>::max() / 64;

    virtual int rate() const = 0;
    /// In samples; `endless` for a stream without an end.
    virtual std::int64_t length() const = 0;
    /// Whether it repeats after its length. Otherwise both sides are silent.
    virtual bool loops() const = 0;
    /// Whether samples arrive in real time.
    virtual bool is_live() const = 0;
    /// The samples first, first + 1, ...; `first` may be any number.
    virtual void read(std::int64_t first, std::span<StereoSample> samples) const = 0;
};

/// The part of a sound to read, and whether it loops.
struct SoundPart {
    std::int64_t first = 0;  // sample frame of its start
    bool loops = false;
    std::int64_t end = 0;  // the sample frame after its last one; 0: the end of the sound

    /// The number of its frames in a sound of this length.
    std::int64_t length_in(std::int64_t frames) const {
        return (end > 0 ? std::min(end, frames) : frames) - first;
    }
};

/// The channels read as left and right, from 1; 0: silence. A number above the last channel means
/// the last one, so mono is on both sides.
struct StreamChannels {
    int left = 1;
    int right = 2;
};

/// A sound in memory. It must have a rate, a channel and a sample from part.first on.
std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const Sound> sound,
                                              const SoundPart& part,
                                              const StreamChannels& channels = {});

/// A live sound. Its sample 0 is the frame `first`, which may be in the future or before the first
/// frame.
std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const LiveSound> sound,
                                              std::int64_t first,
                                              const StreamChannels& channels = {});
