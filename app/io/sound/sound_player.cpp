#include "io/sound/sound_player.h"

#include <algorithm>
#include <cmath>

namespace {
// NaN becomes `low`.
double bounded(double value, double low, double high) {
    return value >= low ? std::min(value, high) : low;
}
}  // namespace

void SoundPlayer::play(std::shared_ptr<const Sound> sound, double start_seconds,
                       double end_seconds) {
    m_track = nullptr;  // the old sound must not restart
    seek(0.0);
    if (sound) {
        const double start = bounded(start_seconds, 0.0, sound->seconds()) * sound->rate;
        const std::size_t first = std::min(static_cast<std::size_t>(start), sound->frame_count());
        const double last = bounded(end_seconds, 0.0, sound->seconds()) * sound->rate;
        const auto rounded = static_cast<std::size_t>(std::llround(last));
        const std::size_t end =
            rounded > first ? std::min(rounded, sound->frame_count()) : sound->frame_count();
        m_tracks.push_back(std::make_unique<const Track>(Track{std::move(sound), first, end}));
        m_track = m_tracks.back().get();
    }
    drop_unused_tracks();
}

// mix() publishes the track that it reads, then checks that it is still current. A track that is
// neither current nor in use is therefore never read again.
void SoundPlayer::drop_unused_tracks() {
    const Track* current = m_track;
    const Track* in_use = m_in_use;
    std::erase_if(m_tracks, [&](const std::unique_ptr<const Track>& track) {
        return track.get() != current && track.get() != in_use;
    });
}

void SoundPlayer::seek(double seconds) {
    constexpr double longest = 1e9;
    m_seek_seconds = bounded(seconds, 0.0, longest);
    ++m_jump;
}

void SoundPlayer::set_level(double level) {
    m_level.set(bounded(level, 0.0, 2.0));
}

void SoundPlayer::set_speed(double speed) {
    m_speed = bounded(speed, 0.01, 4.0);
}

const SoundPlayer::Track* SoundPlayer::begin_reading() noexcept {
    const Track* track = m_track;
    do {
        m_in_use = track;
    } while (m_in_use != (track = m_track));
    return track;
}

void SoundPlayer::follow_seek(const Sound& sound) noexcept {
    const std::uint64_t asked = m_jump;
    if (asked != m_jump_followed)
        m_position = m_seek_seconds * sound.rate;
    m_jump_followed = asked;
}

SoundPlayer::Mixed SoundPlayer::mix(std::span<float> stereo) noexcept {
    std::fill(stereo.begin(), stereo.end(), 0.0f);
    Mixed mixed;
    if (const Track* const track = begin_reading()) {
        const Sound& sound = *track->sound;
        const auto length = static_cast<double>(track->frame_count());
        const bool loops = m_loops && length > 0.0;
        follow_seek(sound);
        if (!loops)
            m_position = std::min(m_position, length);
        const bool is_still = m_is_paused || (!loops && m_position == length);
        mixed = {m_position / sound.rate, is_still ? 0.0 : m_speed.load(), m_jump_followed};
        const double step = mixed.seconds_per_second * sound.rate / m_device_rate;
        if (!is_still)
            add_sound(*track, {step, loops}, stereo);
    }
    m_in_use = nullptr;
    m_level.apply(stereo);
    return mixed;
}

void SoundPlayer::add_sound(const Track& track, const Pace& pace,
                            std::span<float> stereo) noexcept {
    const Sound& sound = *track.sound;
    const std::size_t count = track.frame_count();
    const float* const samples = track.samples();
    const auto length = static_cast<double>(count);
    const auto channels = static_cast<std::size_t>(sound.channels);
    const std::size_t right = channels > 1 ? 1 : 0;
    double position = pace.loops ? std::fmod(m_position, length) : m_position;
    for (std::size_t i = 0; i + 1 < stereo.size() && position < length; i += 2) {
        const auto below = static_cast<std::size_t>(position);
        const bool is_last = below + 1 == count;
        const float* from = samples + below * channels;
        const float* to = is_last ? samples : from + channels;
        const auto part = static_cast<float>(position - static_cast<double>(below));
        const float weight = is_last && !pace.loops ? 0.0f : part;  // silence after the end
        stereo[i] = from[0] * (1.0f - part) + to[0] * weight;
        stereo[i + 1] = from[right] * (1.0f - part) + to[right] * weight;
        position += pace.step;
        m_position += pace.step;
        if (pace.loops && position >= length)
            position = std::fmod(position, length);
    }
}
