#include "signals/audio/sound_peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace {
constexpr std::size_t peak_block = 128;  // frames of a block on the lowest level
constexpr std::size_t level_step = 16;   // blocks of a block on the next level

/// An empty range, which any sample extends.
constexpr Peak no_peak{std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity()};

void extend(Peak& peak, const Peak& other) {
    peak.low = std::min(peak.low, other.low);
    peak.high = std::max(peak.high, other.high);
}

void extend(Peak& peak, float sample) {
    const float finite = std::isfinite(sample) ? sample : 0.0f;
    extend(peak, Peak{finite, finite});
}

// The frame at a time, within the sound.
std::size_t frame_at(double seconds, const Sound& sound) {
    const double frame = std::floor(seconds * sound.rate);
    return frame > 0.0
               ? std::min(static_cast<std::size_t>(std::min(frame, 9e15)), sound.frame_count())
               : 0;
}
}  // namespace

std::optional<SoundPeaks> SoundPeaks::measure(std::shared_ptr<const Sound> sound,
                                              JobProgress& work) {
    SoundPeaks peaks(std::move(sound));
    if (!peaks.measure_blocks(work))
        return std::nullopt;
    for (std::size_t side = 0; side < side_count; ++side)
        peaks.add_levels(side);
    return peaks;
}

std::size_t SoundPeaks::channel_of(std::size_t side) const {
    return std::min(side, static_cast<std::size_t>(std::max(m_sound->channels, 1)) - 1);
}

bool SoundPeaks::measure_blocks(JobProgress& work) {
    const std::size_t frames = m_sound->frame_count();
    const auto channels = static_cast<std::size_t>(std::max(m_sound->channels, 1));
    for (std::vector<Level>& levels : m_levels)
        levels.emplace_back().reserve(frames / peak_block + 1);
    constexpr std::size_t between_reports = 4096;  // blocks
    for (std::size_t first = 0; first < frames; first += peak_block) {
        if (first / peak_block % between_reports == 0) {
            work.share = static_cast<double>(first) / static_cast<double>(frames);
            if (work.is_cancelled)
                return false;
        }
        const std::size_t end = std::min(first + peak_block, frames);
        for (std::size_t side = 0; side < side_count; ++side) {
            Peak peak = no_peak;
            for (std::size_t frame = first; frame < end; ++frame)
                extend(peak, m_sound->samples[frame * channels + channel_of(side)]);
            m_levels[side].front().push_back(peak);
        }
    }
    return true;
}

void SoundPeaks::add_levels(std::size_t side) {
    std::vector<Level>& levels = m_levels[side];
    while (levels.back().size() > level_step) {
        Level next;
        for (std::size_t first = 0; first < levels.back().size(); first += level_step) {
            Peak peak = no_peak;
            const std::size_t end = std::min(first + level_step, levels.back().size());
            for (std::size_t i = first; i < end; ++i)
                extend(peak, levels.back()[i]);
            next.push_back(peak);
        }
        levels.push_back(std::move(next));
    }
}

// Single samples up to the next block, then blocks of the largest level that fits.
Peak SoundPeaks::peak(std::size_t side, std::size_t first, std::size_t end) const {
    const auto channels = static_cast<std::size_t>(std::max(m_sound->channels, 1));
    const std::vector<Level>& levels = m_levels[side];
    end = std::min(end, m_sound->frame_count());
    if (first >= end)
        return {};
    Peak peak = no_peak;
    while (first < end) {
        std::size_t size = 1;
        std::size_t level = levels.size();  // none: a single sample
        for (std::size_t i = 0, frames = peak_block; i < levels.size(); ++i, frames *= level_step)
            if (first % frames == 0 && first + frames <= end) {
                level = i;
                size = frames;
            }
        if (level < levels.size())
            extend(peak, levels[level][first / size]);
        else
            extend(peak, m_sound->samples[first * channels + channel_of(side)]);
        first += size;
    }
    return peak;
}

std::vector<Peak> SoundPeaks::columns(std::size_t side, double start, double end,
                                      std::size_t columns) const {
    std::vector<Peak> peaks;
    const double width = (end - start) / static_cast<double>(std::max<std::size_t>(columns, 1));
    const bool is_wide = width * m_sound->rate >= 8.0 * peak_block;
    // The ends of wide columns are those of blocks, which is fast and shifts them by less than an
    // eighth of a column.
    const auto end_of = [&](double seconds) {
        const std::size_t frame = frame_at(seconds, *m_sound);
        return is_wide && frame < m_sound->frame_count() ? frame / peak_block * peak_block : frame;
    };
    for (std::size_t i = 0; i < columns; ++i) {
        const double left = start + width * static_cast<double>(i);
        const std::size_t first = end_of(left);
        const std::size_t last = end_of(left + width);
        // A column that is shorter than a sample shows the sample that it lies in.
        const bool is_outside = left + width <= 0.0;
        peaks.push_back(peak(side, first, is_outside ? first : std::max(last, first + 1)));
    }
    return peaks;
}
