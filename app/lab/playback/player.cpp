#include "lab/playback/player.h"

#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

Player::Player(std::unique_ptr<SoundDevices> devices, double sender_timeout)
    : m_devices(std::move(devices)),
      m_signal(m_devices.has_devices() ? BeamInput::Pace::live : BeamInput::Pace::waiting,
               sender_timeout) {}

Result<void> Player::set_signal(const Spec& spec, SignalFile sound) {
    auto complete = spec.kind.empty() ? Result<Spec>(Spec()) : completed(spec);
    if (!complete)
        return fail(complete.error());
    const bool is_heard = m_error.empty() && m_devices.is_beam_as_set();
    if (is_heard && m_signal.is_current(*complete, sound))
        return {};  // such as after an edit of the look
    return start(std::move(*complete), std::move(sound));
}

// Without a device, playback continues silently.
Result<void> Player::start(Spec complete, SignalFile sound) {
    const SignalKind* kind = find_kind(complete.kind);
    if (auto opened = m_signal.open_input(complete, m_devices, m_transport.time()); !opened) {
        if (kind && kind->is_live)
            m_error = opened.error().front().message;
        return opened;
    }
    if (auto set = m_signal.set(std::move(complete), std::move(sound)); !set)
        return set;
    m_error.clear();
    if (const auto played = play_beam(); !played)
        m_error = played.error().front().message;
    if (const auto played = m_devices.play_sound(m_signal.track(), m_transport);
        !played && m_error.empty())
        m_error = played.error().front().message;
    return {};
}

// The beam has a signal of its own, because signals can have state.
Result<void> Player::play_beam() {
    const bool is_played = m_devices.settings().plays_beam;
    return m_devices.play_beam(is_played ? m_signal.copy() : nullptr,
                               !m_signal.is_live() && !m_signal.feed());
}

Result<void> Player::mute_input(bool is_muted) {
    if (m_signal.live_input().is_muted() == is_muted)
        return {};
    m_signal.live_input().set_muted(is_muted);
    return m_signal.is_live() ? start(m_signal.spec(), m_signal.sound()) : Result<void>();
}

Result<void> Player::set_sound_settings(const SoundSettings& settings) {
    if (!m_devices.set_settings(settings))
        return {};
    m_signal.live_input().close();
    return start(m_signal.spec(), m_signal.sound());
}

std::string Player::error() const {
    if (const BeamFeed* feed = m_signal.feed())
        if (std::string complaint = feed->complaint(); !complaint.empty())
            return complaint;
    const bool is_muted = m_signal.is_live() && m_signal.live_input().is_muted();
    return is_muted ? "Live sound is muted" : m_error;
}

void Player::play() {
    m_transport.set_playing(true);
    m_devices.follow(m_transport);
}

void Player::pause() {
    m_transport.set_playing(false);
    m_devices.follow(m_transport);
}

void Player::set_speed(double speed) {
    m_transport.set_speed(speed);
    m_devices.follow(m_transport);
}

void Player::restart() {
    m_transport.restart();
    seek(0.0);
}

void Player::seek(double seconds) {
    m_transport.seek(seconds);
    m_devices.seek(m_transport.time());
    m_signal.seek(m_transport.time());
    if (m_signal.live_input().is_open())
        (void)play_beam();  // its signal starts at another position
}

void Player::seek_with_past(double seconds, std::size_t frames) {
    seek(seconds);
    m_transport.fill_past(frames);
}

void Player::go_back_to(std::int64_t frame) {
    if (m_transport.go_back_to(frame))
        seek(m_transport.time());
}

PlayedFrame Player::advance_fixed(double fps, int subframes) {
    m_transport.set_subframes(subframes);
    return m_transport.advance_fixed(fps);
}

std::optional<PlayedFrame> Player::advance(double wall_seconds, int subframes) {
    m_transport.set_subframes(subframes);
    auto frame = advance_clock(wall_seconds);
    m_devices.advance_beam(m_transport);
    return frame;
}

std::optional<PlayedFrame> Player::advance_clock(double wall_seconds) {
    report_stall();
    if (const auto frame = m_transport.take_step()) {
        m_devices.seek(m_transport.time());
        return frame;
    }
    if (!m_transport.is_playing())
        return std::nullopt;
    if (m_signal.live_input().is_open())
        return advance_live(wall_seconds);
    const double seconds =
        m_devices.is_clock() ? m_devices.take_played_seconds() : wall_seconds * m_transport.speed();
    return m_transport.advance({.seconds = seconds,
                                .wall_seconds = wall_seconds,
                                .skips_excess = m_devices.plays_in_real_time()});
}

// Skips input that was received during a pause or a stall.
std::optional<PlayedFrame> Player::advance_live(double wall_seconds) {
    const LiveInput& input = m_signal.live_input();
    if (input.has_stalled())
        return m_transport.advance_to(m_transport.time() +
                                      std::min(wall_seconds, m_transport.longest_frame()));
    const double delay_ms = std::max(m_devices.settings().picture_delay_ms, 0.0);
    return m_transport.advance_to(input.end_seconds() - 0.001 * delay_ms);
}

// Reports a stalled device once. The picture continues with the wall clock.
void Player::report_stall() {
    if (!m_error.empty())
        return;
    m_error = m_devices.stall();
    if (m_error.empty() && m_signal.live_input().has_stalled())
        m_error = fmt::format("No input from \"{}\"", m_signal.live_input().device_name());
}
