#include "lab/playback/audio_devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

bool AudioDevices::set_settings(const SoundSettings& settings) {
    SoundSettings same_devices = settings;
    same_devices.picture_delay_ms = m_settings.picture_delay_ms;
    same_devices.beam_level = m_settings.beam_level;
    if (m_playout)
        m_playout->set_level(settings.beam_level);
    const bool needs_devices = m_machine && same_devices != m_settings;
    m_settings = settings;
    if (!needs_devices)
        return false;
    m_output.reset();
    m_playout.reset();
    m_track = {};  // is new for the new device
    return true;
}

std::vector<SoundDevice> AudioDevices::list() const {
    return m_machine ? m_machine->list() : std::vector<SoundDevice>();
}

Result<std::unique_ptr<SoundCapture>> AudioDevices::open_capture(int channels) const {
    return m_machine->open_capture(m_settings, channels);
}

Result<void> AudioDevices::play_beam(std::unique_ptr<Signal> signal, bool is_known_ahead) {
    if (!m_machine || !m_settings.plays_beam || !signal) {
        m_playout.reset();
        return {};
    }
    if (!m_playout) {
        auto output = m_machine->open_beam_output(m_settings);
        if (!output) {
            m_settings.plays_beam = false;
            return fail(output.error());
        }
        m_output.reset();
        m_playout = std::make_unique<BeamPlayout>(std::move(*output));
        m_playout->set_level(m_settings.beam_level);
    }
    m_playout->set_signal(std::move(signal), is_known_ahead);
    return {};
}

Result<void> AudioDevices::play_sound(const SoundTrack& track, const Transport& transport) {
    const bool is_new = track.sound != m_track.sound ||
                        track.start_seconds != m_track.start_seconds ||
                        track.end_seconds != m_track.end_seconds;
    m_track = track;
    if (m_machine && track.sound && !m_output && !m_playout) {
        auto output = m_machine->open_output(m_settings);
        if (!output) {
            m_track = {};  // is new for a device that is connected later
            return fail(output.error());
        }
        m_output = std::move(*output);
    }
    if (!m_output)
        return {};
    if (is_new)
        m_output->play(track.sound, track.start_seconds, track.end_seconds);
    if (!track.sound)
        return {};
    m_output->set_loop(track.loops);
    m_output->set_level(m_level);
    if (is_new)
        seek(transport.time());
    follow(transport);
    return {};
}

void AudioDevices::follow(const Transport& transport) {
    if (m_output) {
        m_output->set_speed(transport.speed());
        transport.is_playing() ? m_output->play() : m_output->pause();
    }
    if (m_playout && !transport.is_playing())
        m_playout->rest();
}

void AudioDevices::advance_beam(const Transport& transport) {
    if (m_playout && transport.is_playing())
        m_playout->follow(transport.time(), transport.speed());
}

void AudioDevices::seek(double seconds) {
    if (m_output)
        m_output->seek(seconds);
    m_heard = seconds;
    if (m_playout)
        m_playout->rest();
}

void AudioDevices::set_level(double level) {
    m_level = std::clamp(level, 0.0, 2.0);
    if (m_output)
        m_output->set_level(m_level);
}

bool AudioDevices::is_clock() const {
    return m_track.sound && m_output && !m_output->has_stalled();
}

double AudioDevices::take_played_seconds() {
    const double position = m_output->position_seconds() - 0.001 * m_settings.picture_delay_ms;
    const double later = std::max(position, m_heard);  // waits if the picture is delayed
    return later - std::exchange(m_heard, later);
}

std::string AudioDevices::stall() const {
    if (m_playout && m_playout->has_stalled())
        return fmt::format("Audio device \"{}\" stopped. The beam isn't sent any more.",
                           m_playout->device_name());
    if (m_track.sound && m_output && m_output->has_stalled())
        return fmt::format("Audio device \"{}\" stopped. Playing silently.",
                           m_output->device_name());
    return {};
}
