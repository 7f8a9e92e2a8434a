#pragma once

#include "base/job_progress.h"
#include "model/devices/sound.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

/// The lowest and highest sample of a range.
struct Peak {
    float low = 0.0f;
    float high = 0.0f;

    bool operator==(const Peak&) const = default;
};

/// The peaks of a sound's first two channels, for drawing its waveform at any zoom. A pyramid of
/// minima and maxima makes every query fast. A mono sound has its channel on both sides. Samples
/// that are not finite count as 0.
class SoundPeaks {
public:
    static constexpr std::size_t side_count = 2;

    /// Reads the whole sound; for a worker thread. nullopt: cancelled.
    static std::optional<SoundPeaks> measure(std::shared_ptr<const Sound> sound, JobProgress& work);

    const Sound& sound() const { return *m_sound; }
    /// The exact peak of the sample frames first .. end - 1 on a side, 0 left or 1 right. Frames
    /// outside the sound are ignored; without any, the peak is 0.
    Peak peak(std::size_t side, std::size_t first, std::size_t end) const;
    /// The peaks of `columns` equal parts of the time from `start` to `end`, in seconds. Together
    /// they contain every sample of that time.
    std::vector<Peak> columns(std::size_t side, double start, double end,
                              std::size_t columns) const;

private:
    using Level = std::vector<Peak>;

    explicit SoundPeaks(std::shared_ptr<const Sound> sound) : m_sound(std::move(sound)) {}
    std::size_t channel_of(std::size_t side) const;
    bool measure_blocks(JobProgress& work);
    void add_levels(std::size_t side);

    std::shared_ptr<const Sound> m_sound;                 // shared with the signal that draws it
    std::array<std::vector<Level>, side_count> m_levels;  // blocks of 128, 2048, ... frames
};
