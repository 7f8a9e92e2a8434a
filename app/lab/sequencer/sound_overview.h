#pragma once

#include "lab/storage/background_work.h"
#include "signals/audio/sound_peaks.h"

#include <memory>

/// The peaks of the current sound for its waveform, measured on a background thread.
class SoundOverview {
public:
    /// Measures another sound; null: none.
    void follow(const std::shared_ptr<const Sound>& sound);
    /// Call it in every update.
    void update();

    /// Null: no sound, or not measured yet.
    const SoundPeaks* peaks() const { return m_peaks.get(); }
    bool is_measuring() const { return m_work.is_running(); }
    double share() const { return m_work.share(); }

private:
    std::shared_ptr<const Sound> m_sound;  // shared with the signal that draws it
    std::shared_ptr<const SoundPeaks> m_peaks;
    BackgroundWork<std::shared_ptr<SoundPeaks>> m_work;
};
