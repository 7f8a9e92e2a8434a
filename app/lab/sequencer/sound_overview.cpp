#include "lab/sequencer/sound_overview.h"

void SoundOverview::follow(const std::shared_ptr<const Sound>& sound) {
    if (sound == m_sound)
        return;
    m_sound = sound;
    m_peaks.reset();
    m_work.cancel();
    if (!sound)
        return;
    m_work.start([sound](JobProgress& work) -> Result<std::shared_ptr<SoundPeaks>> {
        auto peaks = SoundPeaks::measure(sound, work);
        return peaks ? std::make_shared<SoundPeaks>(std::move(*peaks)) : nullptr;
    });
}

void SoundOverview::update() {
    m_work.update();
    const auto& outcome = m_work.outcome();
    if (!m_peaks && outcome && *outcome && **outcome && &(**outcome)->sound() == m_sound.get())
        m_peaks = **outcome;
}
