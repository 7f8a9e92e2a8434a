#include "lab/player.h"

#include "signals/kinds.h"

#include <algorithm>
#include <utility>

Result<void> Player::set_signal(const Spec& spec, PlayedSound sound) {
    std::unique_ptr<Signal> signal;
    double start = 0.0;
    bool loops = false;
    if (!spec.kind.empty()) {
        const auto complete = completed(spec);
        if (!complete)
            return fail(complete.error());
        auto made = make_signal(*complete, {sound.sound});
        if (!made)
            return fail(made.error());
        signal = std::move(*made);
        if (sound.sound) {
            start = std::get<double>(complete->settings.at("start"));
            loops = complete->settings.at("loop") == Spec::Setting("on");
        }
    }
    const bool is_new_sound = sound.sound != m_sound.sound || start != m_start;
    m_signal = std::move(signal);
    m_sound = std::move(sound);
    m_start = start;
    if (m_is_heard)
        play_sound(loops, is_new_sound);
    return {};
}

double Player::sound_seconds() const {
    return m_sound.sound ? std::max(0.0, m_sound.sound->seconds() - m_start) : 0.0;
}

// The loudspeaker follows the signal. Without a device the wall clock runs instead.
void Player::play_sound(bool loops, bool is_new_sound) {
    m_silence.clear();
    if (m_sound.sound && !m_output) {
        auto output = SoundOutput::open();
        if (output)
            m_output = std::move(*output);
        else
            m_silence = output.error().front().message;
    }
    if (!m_output)
        return;
    if (is_new_sound)
        m_output->play(m_sound.sound, m_start);
    if (!m_sound.sound)
        return;
    m_output->set_loop(loops);
    m_output->set_level(m_level);
    m_output->set_speed(m_speed);
    if (is_new_sound)
        seek(m_time);
    m_is_playing ? m_output->play() : m_output->pause();
}

bool Player::is_sound_the_clock() const {
    return m_sound.sound && m_output && !m_output->has_stalled();
}

void Player::play() {
    m_is_playing = true;
    if (m_output)
        m_output->play();
}

void Player::pause() {
    m_is_playing = false;
    if (m_output)
        m_output->pause();
}

void Player::restart() {
    m_frame = 0;
    m_past.clear();
    seek(0.0);
}

void Player::seek(double seconds) {
    m_time = std::max(0.0, seconds);
    if (m_output)
        m_output->seek(m_time);
    m_heard = m_time;
}

void Player::set_speed(double speed) {
    m_speed = std::clamp(speed, 0.01, 4.0);
    if (m_output)
        m_output->set_speed(m_speed);
}

void Player::set_level(double level) {
    m_level = std::clamp(level, 0.0, 2.0);
    if (m_output)
        m_output->set_level(m_level);
}

// Seconds of the signal that have gone by. A heard sound is the clock: its position says so.
double Player::played_seconds(double wall_seconds) {
    if (!is_sound_the_clock())
        return wall_seconds * m_speed;
    const double position = m_output->position_seconds();
    return std::max(0.0, position - std::exchange(m_heard, position));
}

PlayedFrame Player::moved_to(double end) {
    const PlayedFrame frame{++m_frame, {m_time, end}};
    m_time = end;
    m_past.push_back(frame);
    if (m_past.size() > frames_remembered)
        m_past.pop_front();
    return frame;
}

std::optional<PlayedFrame> Player::advance(double wall_seconds) {
    if (m_is_stepping) {
        m_is_stepping = false;
        const PlayedFrame frame = moved_to(m_time + 1.0 / 60.0);
        if (m_output)
            m_output->seek(m_time);
        m_heard = m_time;
        return frame;
    }
    if (!m_is_playing)
        return std::nullopt;
    const double played = shown_seconds(played_seconds(wall_seconds));
    if (played <= 0.0)
        return std::nullopt;
    return moved_to(m_time + played);
}

void Player::set_longest_frame(double seconds) {
    m_longest_frame = std::clamp(seconds, 1.0 / 240.0, longest_frame);
}

// Time that a frame cannot cover is lost, not light. A sound that is heard goes on meanwhile.
double Player::shown_seconds(double played) {
    if (played <= 0.0)
        return 0.0;
    const double shown = std::min(played, m_longest_frame);
    constexpr double smoothing = 0.1;
    m_shown_share += smoothing * (shown / played - m_shown_share);
    if (is_sound_the_clock())
        m_time += played - shown;
    return shown;
}

PlayedFrame Player::advance_fixed(double fps) {
    const TimeSpan span = frame_span(m_frame + 1, fps);
    m_time = span.start;
    return moved_to(span.end);
}

Beam Player::trace(const TimeSpan& span) const {
    Beam beam;
    if (m_signal)
        m_signal->trace(span, beam);
    return beam;
}
